// Solves for the shell modes of one mesh, natively, and prints JSON: with our solver, and with Spectra on
// Eigen's SimplicialLDLT, as the two are usually combined. Can also write K, M and the shift for other
// solvers.
//
//   shell_modes MESH [--modes 12] [--threads 2] [--thickness 2] [--export FILE] [--simplicial]
//
// MESH, little endian: uint32 vertices, uint32 triangles, float32 positions[3 v + c], uint32 triangles[3 t +
// corner]; one component. FILE: uint32 unknowns, uint32 entries, double shift, then of the lower triangle of
// K by columns int32 columnStart[unknowns + 1], int32 row[entries], double value[entries], and double
// mass[unknowns].

#include <Spectra/SymEigsSolver.h>

#include <Eigen/SparseCholesky>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "base/parallel.h"
#include "elastic/shell.h"
#include "linear/eigensolver.h"
#include "linear/factorisation.h"
#include "linear/ordering/front_tree.h"
#include "linear/ordering/node_graph.h"
#include "linear/ordering/ordering.h"
#include "mesh/topology.h"

namespace limber {
namespace {

constexpr double kPoisson = 0.3;
constexpr int kZeroModes = 6;

struct Options {
  std::string mesh, matrixFile;
  int modeCount = 12, threads = 2;
  double thickness = 2;  // % of the bounding box's diagonal
  bool simplicial = false;
};

Options readArguments(int count, char** values) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string name = values[i];
    const auto next = [&] {
      if (++i == count) throw std::invalid_argument("A value must follow " + name + ".");
      return std::string(values[i]);
    };
    if (name == "--modes")
      options.modeCount = std::stoi(next());
    else if (name == "--threads")
      options.threads = std::stoi(next());
    else if (name == "--thickness")
      options.thickness = std::stod(next());
    else if (name == "--export")
      options.matrixFile = next();
    else if (name == "--simplicial")
      options.simplicial = true;
    else
      options.mesh = name;
  }
  return options;
}

template <class T>
std::vector<T> readArray(std::ifstream& file, size_t count) {
  std::vector<T> values(count);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  if (!file) throw std::runtime_error("The mesh file is missing or too short.");
  return values;
}

// Moved and scaled as in computeModes: the bounding box starts at 0 and its diagonal is 1.
TriangleMesh readMesh(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const auto counts = readArray<uint32_t>(file, 2);
  const auto positions = readArray<float>(file, size_t{3} * counts[0]);
  const auto triangles = readArray<uint32_t>(file, size_t{3} * counts[1]);
  TriangleMesh mesh;
  for (size_t v = 0; v < counts[0]; ++v)
    mesh.positions.push_back({positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]});
  for (size_t t = 0; t < counts[1]; ++t)
    mesh.triangles.push_back({triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]});
  const Bounds box = bounds(mesh);
  const double diagonal = box.diagonal();
  for (Vec3& p : mesh.positions) p = (p - box.low) / diagonal;
  return mesh;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The shift that our solver ends with, by its shift rule (linear/eigensolver.h).
double shiftOf(double scale, double first) {
  return scale > 0.005 * first && scale < 15 * first ? -scale : -0.5 * first;
}

// The seconds spent in each phase of one call and how often each began, from the observer of the job.
struct PhaseClock {
  double seconds[3] = {};  // assembling with ordering, factorising, solving
  int begun[3] = {};

  void watch(Job& job) {
    job.observer = [this](Phase phase, double fraction) {
      const double now = limber::seconds();
      if (current_ >= 0) seconds[current_] += now - last_;
      last_ = now;
      const int index = static_cast<int>(phase) - static_cast<int>(Phase::Assemble);
      current_ = index >= 0 && index < 3 ? index : -1;
      if (current_ >= 0 && fraction == 0) ++begun[current_];
    };
  }
  void stop(Job& job) {
    job.observer(Phase::Idle, 0);
    job.observer = nullptr;
  }

 private:
  int current_ = -1;
  double last_ = 0;
};

void exportMatrix(const SparsePencil& pencil, double shift, const std::string& path) {
  const Eigen::SparseMatrix<double> lower = pencil.k.triangularView<Eigen::Lower>();
  const uint32_t sizes[2] = {static_cast<uint32_t>(lower.rows()), static_cast<uint32_t>(lower.nonZeros())};
  std::ofstream file(path, std::ios::binary);
  const auto write = [&](const auto* values, size_t count) {
    file.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(*values)));
  };
  write(sizes, 2);
  write(&shift, 1);
  write(lower.outerIndexPtr(), sizes[0] + size_t{1});
  write(lower.innerIndexPtr(), sizes[1]);
  write(lower.valuePtr(), sizes[1]);
  write(pencil.m.data(), sizes[0]);
}

// The entries of L that our fronts store, including zeros.
uint64_t storedNonzeros(const SparsePencil& pencil) {
  const Job job;
  const NodeGraph graph = nodeGraph(pencil);
  const auto weightOf = [&](const std::vector<uint32_t>& nodes) {
    uint64_t sum = 0;
    for (uint32_t node : nodes) sum += graph.weight[node];
    return sum;
  };
  uint64_t stored = 0;
  for (const FrontNodes& front : buildFrontTree(graph, eliminationOrder(graph, job), job)) {
    const uint64_t pivots = weightOf(front.pivots);
    stored += pivots * (pivots + 1) / 2 + pivots * weightOf(front.boundary);
  }
  return stored;
}

// M^1/2 (K - shift M)^-1 M^1/2 over the heavy unknowns, by SimplicialLDLT with its default order (AMD).
class SimplicialInverse {
 public:
  using Scalar = double;
  SimplicialInverse(const SparsePencil& pencil, double shift) : size_(pencil.m.size()) {
    Eigen::SparseMatrix<double> shifted = pencil.k;
    for (Eigen::Index i = 0; i < size_; ++i) {
      shifted.coeffRef(i, i) -= shift * pencil.m[i];
      if (pencil.m[i] > 0) heavy_.push_back(i);
    }
    rootMass_ = pencil.m(heavy_).cwiseSqrt();
    solver_.compute(shifted);
    if (solver_.info() != Eigen::Success) throw std::runtime_error("SimplicialLDLT failed.");
  }
  Eigen::Index rows() const { return rootMass_.size(); }
  Eigen::Index cols() const { return rootMass_.size(); }
  void perform_op(const double* in, double* out) const {
    Eigen::VectorXd full = Eigen::VectorXd::Zero(size_);
    full(heavy_) = rootMass_.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(in, rows()));
    const Eigen::VectorXd solved = solver_.solve(full);
    Eigen::Map<Eigen::VectorXd>(out, rows()) = rootMass_.cwiseProduct(solved(heavy_));
  }
  Eigen::Index nonzeros() const { return solver_.matrixL().nestedExpression().nonZeros() + size_; }

 private:
  Eigen::Index size_;
  std::vector<Eigen::Index> heavy_;
  Eigen::VectorXd rootMass_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

void runSimplicial(const SparsePencil& pencil, double shift, int wanted) {
  const double start = seconds();
  SimplicialInverse inverse(pencil, shift);
  const double factorised = seconds();
  Spectra::SymEigsSolver<SimplicialInverse> solver(inverse, wanted, 2 * wanted);
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, 100, 1e-10);
  const double first = 1 / solver.eigenvalues()[kZeroModes] + shift;
  std::printf(",\"simplicial\":{\"seconds\":%.4f,\"factorise\":%.4f,\"nonzeros\":%lld,\"firstLambda\":%.9g}",
              seconds() - start, factorised - start, static_cast<long long>(inverse.nonzeros()), first);
}

void run(const Options& options) {
  setThreadCount(options.threads);
  const TriangleMesh mesh = readMesh(options.mesh);
  const double thickness = options.thickness / 100, scale = 300 * thickness * thickness;
  Job job;
  PhaseClock clock;
  clock.watch(job);
  const double start = seconds();
  job.begin(Phase::Assemble);
  const SparsePencil pencil = shellPencil({mesh, buildTopology(mesh), thickness, kPoisson});
  const double assembled = seconds();
  const EigenSolution solution = solveEigenproblem(pencil, {options.modeCount, kZeroModes, scale}, job);
  const double solved = seconds();
  clock.stop(job);
  const double shift = shiftOf(scale, solution.basis.lambda[0]);

  Factorisation factorisation(pencil, job);
  const double ordered = seconds();
  factorisation.factorise(shift, job);
  const double factorised = seconds();
  Eigen::VectorXd x = Eigen::VectorXd::Ones(pencil.m.size());
  constexpr int kSolves = 10;
  for (int i = 0; i < kSolves; ++i) factorisation.solve(x, job);
  const double substituted = seconds();
  std::printf(
      "{\"vertices\":%u,\"unknowns\":%u,\"threads\":%d,\"shift\":%.17g,\"firstLambda\":%.9g,\"zeroModes\":%u",
      mesh.vertexCount(), pencil.unknownCount(), options.threads, shift, solution.basis.lambda[0],
      solution.nullity);
  std::printf(",\"seconds\":%.4f,\"assemble\":%.4f,\"order\":%.4f,\"factorise\":%.4f,\"substitute\":%.4f",
              solved - start, assembled - start, ordered - solved, factorised - ordered,
              (substituted - factorised) / kSolves);
  std::printf(",\"nonzeros\":%llu,\"storedNonzeros\":%llu,\"multiplications\":%.6g",
              static_cast<unsigned long long>(factorisation.structure().nonzeros()),
              static_cast<unsigned long long>(storedNonzeros(pencil)), factorisation.structure().work());
  std::printf(
      ",\"phases\":{\"assembleAndOrder\":%.4f,\"factorise\":%.4f,\"solve\":%.4f,\"factorisations\":%d}",
      clock.seconds[0], clock.seconds[1], clock.seconds[2], clock.begun[1]);
  if (!options.matrixFile.empty()) exportMatrix(pencil, shift, options.matrixFile);
  if (options.simplicial) runSimplicial(pencil, shift, options.modeCount + kZeroModes);
  std::printf("}\n");
}

}  // namespace
}  // namespace limber

int main(int count, char** values) {
  try {
    limber::run(limber::readArguments(count, values));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
