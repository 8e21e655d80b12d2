// The solvers of the panel in motion, compared with an independent implementation of their energies: small
// vibrations have the frequencies of the stiffness from finite differences of the energy.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "moving_bodies.h"
#include "shapes.h"

namespace limber {
namespace {

using Positions = std::vector<Vec3>;

// Edges with the triangles around them, in the order that the factors are documented to have.
using Edges = std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>>;

Edges edgesOf(const TriangleMesh& mesh) {
  Edges edges;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c) {
      const uint32_t a = mesh.triangles[t][c], b = mesh.triangles[t][(c + 1) % 3];
      edges[std::minmax(a, b)].push_back(t);
    }
  return edges;
}

uint32_t opposite(const Triangle& t, uint32_t a, uint32_t b) {
  return t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
}

struct Constraint {
  std::vector<uint32_t> vertices;  // 2: a spring; 3: a triangle; 4: a hinge, the ends of its edge first
  double stiffness = 0;            // of a triangle 1
  double rest = 0;                 // length or angle
};

double angleAt(const Constraint& c, const Positions& x) {
  const Vec3 edge = x[c.vertices[1]] - x[c.vertices[0]];
  const Vec3 one = cross(edge, x[c.vertices[2]] - x[c.vertices[0]]);
  const Vec3 two = cross(x[c.vertices[3]] - x[c.vertices[0]], edge);
  return std::atan2(dot(cross(one, two), edge) / length(edge), dot(one, two));
}

double lengthAt(const Constraint& c, const Positions& x) {
  return length(x[c.vertices[0]] - x[c.vertices[1]]);
}

// A St. Venant-Kirchhoff triangle in plane stress: A (mu E:E + lambda / 2 tr^2 E) with the strain from
// squared lengths of its edges, by the metric of the rest shape.
double triangleEnergy(const Constraint& c, const Positions& rest, const Positions& x,
                      const SolverConstants& constants) {
  const auto metric = [&](const Positions& at) {
    const Vec3 u = at[c.vertices[1]] - at[c.vertices[0]], v = at[c.vertices[2]] - at[c.vertices[0]];
    Eigen::Matrix2d m;
    m << dot(u, u), dot(u, v), dot(u, v), dot(v, v);
    return m;
  };
  const Eigen::Matrix2d before = metric(rest);
  const Eigen::Matrix2d strain = 0.5 * before.inverse() * (metric(x) - before);  // mixed components
  const double area = 0.5 * std::sqrt(before.determinant()), trace = strain.trace();
  return c.stiffness * area *
         (constants.stretch * (strain * strain).trace() + 0.5 * constants.secondStretch * trace * trace);
}

// A solver on a mesh, implemented only from the descriptions in solver_model.h and solver_constraints.h.
struct Reference {
  TriangleMesh mesh;
  SimulatedSolver solver;
  std::vector<Constraint> constraints;
  std::vector<double> masses;

  Reference(const TriangleMesh& of, const SimulatedSolver& with)
      : mesh(of), solver(with), masses(with.masses) {
    addStretch();
    addBend();
    if (!masses.empty()) return;
    masses.assign(mesh.vertexCount(), 0.0);
    double sum = 0;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
      for (const uint32_t v : mesh.triangles[t]) {
        const double mass = solver.constants.surfaceDensity * triangleArea(mesh, t) / 3;
        masses[v] += mass;
        sum += mass;
      }
    if (solver.model.mass == MassRule::Vertex) masses.assign(mesh.vertexCount(), sum / mesh.vertexCount());
  }

  void addStretch() {
    const auto factor = [&](size_t i) {
      return solver.stretchFactors.empty() ? 1 : solver.stretchFactors[i];
    };
    if (solver.model.stretch == StretchElement::Membrane) {
      for (const Triangle& t : mesh.triangles)
        constraints.push_back({{t[0], t[1], t[2]}, factor(constraints.size()), 0});
      return;
    }
    for (const auto& [edge, triangles] : edgesOf(mesh)) {
      constraints.push_back(
          {{edge.first, edge.second}, solver.constants.stretch * factor(constraints.size()), 0});
      constraints.back().rest = lengthAt(constraints.back(), mesh.positions);
    }
  }

  void addBend() {
    size_t index = 0;
    for (const auto& [edge, triangles] : edgesOf(mesh)) {
      if (triangles.size() != 2) continue;
      const auto [i, j] = edge;
      const uint32_t k = opposite(mesh.triangles[triangles[0]], i, j),
                     l = opposite(mesh.triangles[triangles[1]], i, j);
      const double size = length(mesh.positions[i] - mesh.positions[j]);
      double stiffness =
          solver.constants.bend * (solver.bendFactors.empty() ? 1 : solver.bendFactors[index++]);
      if (solver.model.bend == BendElement::HingeByLength) stiffness *= size;
      if (solver.model.bend == BendElement::HingeByArea)
        stiffness *= 3 * size * size / (triangleArea(mesh, triangles[0]) + triangleArea(mesh, triangles[1]));
      const bool isSpring = solver.model.bend == BendElement::CrossSprings;
      constraints.push_back({isSpring ? std::vector{k, l} : std::vector{i, j, k, l}, stiffness, 0});
      Constraint& made = constraints.back();
      made.rest = isSpring ? lengthAt(made, mesh.positions) : angleAt(made, mesh.positions);
    }
  }

  double energyOf(const Constraint& c, const Positions& x) const {
    if (c.vertices.size() == 3) return triangleEnergy(c, mesh.positions, x, solver.constants);
    const double strain = (c.vertices.size() == 2 ? lengthAt(c, x) : angleAt(c, x)) - c.rest;
    return 0.5 * c.stiffness * strain * strain;
  }

  double energy(const Positions& x) const {
    double sum = 0;
    for (const Constraint& c : constraints) sum += energyOf(c, x);
    return sum;
  }

  // The second derivative of the energy at rest by central differences, constraint by constraint.
  Eigen::MatrixXd stiffness() const {
    const Eigen::Index size = 3 * static_cast<Eigen::Index>(mesh.vertexCount());
    const double step = 1e-6 * bounds(mesh).diagonal();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
    Positions x = mesh.positions;
    for (const Constraint& c : constraints)
      for (const uint32_t v : c.vertices)
        for (const uint32_t w : c.vertices)
          for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) {
              double second = 0;
              for (const int sv : {1, -1})
                for (const int sw : {1, -1}) {
                  x[v][a] += sv * step;
                  x[w][b] += sw * step;
                  second += sv * sw * energyOf(c, x);
                  x[w] = mesh.positions[w];
                  x[v] = mesh.positions[v];
                }
              sum(3 * v + a, 3 * w + b) += second / (4 * step * step);
            }
    return sum;
  }
};

const Job kJob;

SimulationOptions optionsOf(const SimulatedSolver& solver, int substeps) {
  SimulationOptions options;
  options.material = {1e6, 0.3, 1000, 0.01, 1};
  options.solver = solver;
  options.substeps = substeps;
  return options;
}

// Random numbers between half and twice, the same in every run.
std::vector<double> factors(size_t count, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<double> out;
  for (size_t i = 0; i < count; ++i) out.push_back(0.5 + 1.5 * (random() / 4294967296.0));
  return out;
}

size_t innerEdges(const TriangleMesh& mesh) {
  size_t count = 0;
  for (const auto& [edge, triangles] : edgesOf(mesh)) count += triangles.size() == 2;
  return count;
}

SimulatedSolver tuned(const TriangleMesh& mesh, SimulatedSolver solver) {
  const bool isMembrane = solver.model.stretch == StretchElement::Membrane;
  solver.stretchFactors = factors(isMembrane ? mesh.triangleCount() : edgesOf(mesh).size(), 1);
  solver.bendFactors = factors(innerEdges(mesh), 2);
  solver.masses = factors(mesh.vertexCount(), 3);
  return solver;
}

// Stretching and bending frequencies of the shapes below lie within a factor of about ten.
const SolverConstants kConstants = {1000, 800, 5, 0.3, 2, 1};

std::vector<SimulatedSolver> panel() {
  std::vector<SimulatedSolver> solvers;
  for (const StretchElement stretch : {StretchElement::Membrane, StretchElement::EdgeSprings})
    for (const BendElement bend : {BendElement::HingeByArea, BendElement::HingeByLength, BendElement::Hinge,
                                   BendElement::CrossSprings}) {
      SolverConstants constants = kConstants;
      if (bend == BendElement::CrossSprings) constants.bend = 100;
      const MassRule rule = bend == BendElement::Hinge ? MassRule::Vertex : MassRule::Area;
      solvers.push_back({{stretch, bend, rule}, constants, {}, {}, {}});
    }
  return solvers;
}

// A quarter of a tube, with borders, wound both ways at random: an elastic body for every solver, while a
// flat plate of springs does not resist bending.
TriangleMesh arch(int cells) {
  TriangleMesh mesh = shapes::jittered(shapes::grid(cells, cells), 0.25 / cells, 5);
  for (Vec3& p : mesh.positions) {
    const double angle = 1.5 * p.x;
    p = {std::sin(angle) * (0.7 + p.z), p.y, std::cos(angle) * (0.7 + p.z)};
  }
  return mesh;
}

struct Vibration {
  double omega;
  Positions shape;
};

// The elastic vibrations first to last, counted from 0 after the rigid motions.
std::vector<Vibration> vibrationsOf(const Reference& reference, int first, int last) {
  const auto count = static_cast<Eigen::Index>(reference.masses.size());
  Eigen::VectorXd root(3 * count);
  for (Eigen::Index v = 0; v < count; ++v)
    root.segment<3>(3 * v).setConstant(1 / std::sqrt(reference.masses[static_cast<size_t>(v)]));
  const Eigen::MatrixXd scaled = root.asDiagonal() * reference.stiffness() * root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(scaled);
  EXPECT_LT(std::abs(solved.eigenvalues()[5]), 1e-3 * solved.eigenvalues()[6]);  // six rigid motions
  std::vector<Vibration> vibrations;
  for (int k = first; k <= last; ++k) {
    const Eigen::VectorXd shape = root.asDiagonal() * solved.eigenvectors().col(6 + k);
    Vibration vibration = {std::sqrt(solved.eigenvalues()[6 + k]), {}};
    for (Eigen::Index v = 0; v < count; ++v)
      vibration.shape.push_back({shape[3 * v], shape[3 * v + 1], shape[3 * v + 2]});
    vibrations.push_back(vibration);
  }
  return vibrations;
}

// The measured period of a struck vibration over its true one, with substeps of a 9,600th of it.
double simulatedPeriod(Reference reference, const Vibration& vibration) {
  const double period = 2 * std::acos(-1.0) / vibration.omega;
  SolverConstants& constants = reference.solver.constants;
  // A period is to take 40 steps.
  const double scale = std::pow(period / (40 * Simulation::kStep), 2);
  for (double* stiffness : {&constants.stretch, &constants.secondStretch, &constants.bend})
    *stiffness *= scale;
  Simulation body(reference.mesh, optionsOf(reference.solver, 480));
  double largest = 0;
  for (const Vec3& u : vibration.shape) largest = std::max(largest, length(u));
  Positions velocities;
  for (const Vec3& u : vibration.shape) velocities.push_back(u * (2e-4 / largest));
  body.setVelocities(velocities);
  const auto share = [&] {
    double sum = 0;
    for (uint32_t v = 0; v < body.vertexCount(); ++v)
      sum += reference.masses[v] * dot(vibration.shape[v], body.position(v) - reference.mesh.positions[v]);
    return sum;
  };
  return moving_bodies::periodOf(body, 90, share) / 40;
}

// The remainder is the error of XPBD, which falls with the substep: the softest vibration of springs is 1 %
// too slow at 240 substeps, half of that here, and four times that at 60.
TEST(SimulatedSolvers, smallVibrationsHaveTheFrequenciesOfTheLinearStiffness) {
  const TriangleMesh mesh = arch(4);
  for (const SimulatedSolver& solver : panel())
    for (const SimulatedSolver& own : {solver, tuned(mesh, solver)}) {
      const Reference reference(mesh, own);
      for (const Vibration& vibration : vibrationsOf(reference, 0, 3))
        EXPECT_NEAR(simulatedPeriod(reference, vibration), 1, 0.015)
            << static_cast<int>(own.model.stretch) << " " << static_cast<int>(own.model.bend) << " "
            << own.masses.size();
    }
}

Positions deformed(const TriangleMesh& mesh, double size) {
  Positions x = mesh.positions;
  std::mt19937 random(9);
  for (Vec3& p : x)
    for (int c = 0; c < 3; ++c) p[c] += size * (random() / 4294967296.0 - 0.5);
  return x;
}

// Moves a body to these positions in one step without elasticity being able to answer.
void moveTo(Simulation& body, const TriangleMesh& mesh, const Positions& x) {
  Positions velocities;
  for (size_t v = 0; v < x.size(); ++v) velocities.push_back((x[v] - mesh.positions[v]) / Simulation::kStep);
  body.setVelocities(velocities);
  body.step(kJob);
}

TEST(SimulatedSolvers, theirEnergyIsTheOneWrittenDown) {
  TriangleMesh mesh = shapes::torus(14, 9);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);  // wound against its neighbours
  for (SimulatedSolver solver : panel()) {
    solver = tuned(mesh, solver);
    for (double& mass : solver.masses) mass *= 1e3;
    Simulation body(mesh, optionsOf(solver, 1));
    moveTo(body, mesh, deformed(mesh, 0.1));
    const double expected = Reference(mesh, solver).energy(body.positions());
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(body.elasticEnergy() / expected, 1, 1e-6);
  }
}

TEST(SimulatedSolvers, factorsStayWithTheirConstraintsWhereBodiesAreCutIntoBlocks) {
  const TriangleMesh mesh = shapes::box(28, 28, 60, 1.0 / 28);
  for (SimulatedSolver solver : panel()) {
    solver = tuned(mesh, solver);
    for (double& mass : solver.masses) mass *= 1e3;
    Simulation body(mesh, optionsOf(solver, 1));
    moveTo(body, mesh, deformed(mesh, 0.3 / 28));
    const Reference reference(mesh, solver);
    EXPECT_NEAR(body.elasticEnergy() / reference.energy(body.positions()), 1, 1e-5);
    double mass = 0;
    for (const double own : solver.masses) mass += own;
    EXPECT_NEAR(body.mass() / mass, 1, 1e-12);
  }
}

// Struck so that it is deformed everywhere.
Simulation struckBody(const TriangleMesh& mesh, const SimulatedSolver& solver, int substeps) {
  Simulation body(mesh, optionsOf(solver, substeps));
  Positions velocities;
  for (const Vec3& p : mesh.positions)
    velocities.push_back({std::sin(7 * p.y), 0.5 * std::sin(9 * p.z), std::cos(8 * p.x + p.y)});
  body.setVelocities(velocities);
  return body;
}

// XPBD loses energy as implicit Euler steps do: in proportion to the substep, and it never gains any.
TEST(SimulatedSolvers, aStruckBodyLosesEnergyInProportionToTheSubstepAndGainsNone) {
  const TriangleMesh mesh = arch(5);
  for (const SimulatedSolver& solver : panel()) {
    std::vector<double> losses;
    for (const int substeps : {400, 800}) {
      Simulation body = struckBody(mesh, solver, substeps);
      const double energy = body.kineticEnergy();
      double mostElastic = 0, mostOfAll = 0;
      for (int i = 0; i < 12; ++i) {
        body.step(kJob);
        mostElastic = std::max(mostElastic, body.elasticEnergy());
        mostOfAll = std::max(mostOfAll, body.kineticEnergy() + body.elasticEnergy());
      }
      EXPECT_GT(mostElastic, 0.1 * energy);
      EXPECT_LT(mostOfAll, 1.001 * energy);
      losses.push_back(1 - (body.kineticEnergy() + body.elasticEnergy()) / energy);
    }
    EXPECT_GT(losses[1], 0);
    EXPECT_LT(losses[0], 0.2);
    EXPECT_NEAR(losses[1] / losses[0], 0.5, 0.1);
  }
}

TEST(SimulatedSolvers, aStruckBodyKeepsItsMomenta) {
  const TriangleMesh mesh = arch(5);
  for (const SimulatedSolver& solver : panel()) {
    const Reference reference(mesh, solver);
    Simulation body = struckBody(mesh, solver, 100);
    const auto momenta = [&] {
      Vec3 linear, angular;
      for (uint32_t v = 0; v < body.vertexCount(); ++v) {
        linear += body.velocity(v) * reference.masses[v];
        angular += cross(body.position(v), body.velocity(v) * reference.masses[v]);
      }
      return std::pair{linear, angular};
    };
    double scale = 0;  // of momenta that do not cancel out
    for (uint32_t v = 0; v < body.vertexCount(); ++v) scale += reference.masses[v] * length(body.velocity(v));
    const auto before = momenta();
    for (int i = 0; i < 30; ++i) body.step(kJob);
    const auto after = momenta();
    EXPECT_LT(length(after.first - before.first), 1e-4 * scale);
    EXPECT_LT(length(after.second - before.second), 5e-4 * scale * bounds(mesh).diagonal());
  }
}

TEST(SimulatedSolvers, theNumberOfThreadsChangesNoBit) {
  const TriangleMesh mesh = shapes::box(28, 28, 60, 1.0 / 28);
  for (const SimulatedSolver& solver : panel()) {
    std::vector<Positions> runs;
    for (const int threads : {1, 3}) {
      setThreadCount(threads);
      Simulation body(mesh, optionsOf(tuned(mesh, solver), 3), {{0, 1, 2}, {}});
      body.setGravity({0, -9.81, 0});
      for (int i = 0; i < 2; ++i) body.step(kJob);
      runs.push_back(body.positions());
    }
    setThreadCount(1);
    EXPECT_TRUE(runs[0] == runs[1]);
  }
}

TEST(SimulatedSolvers, theShellOfConstantsIsTheShellOfItsMaterial) {
  const TriangleMesh mesh = shapes::torus(12, 8);
  const ElasticMaterial material = {1e6, 0.3, 1000, 0.02, 1};
  const double h = material.thickness, nu = material.poisson;
  const double mu = material.young * h / (2 * (1 + nu)), lambda = material.young * h * nu / (1 - nu * nu);
  const double d = material.young * h * h * h / (12 * (1 - nu * nu));
  SimulationOptions options;
  options.material = material;
  options.substeps = 20;
  Simulation shell(mesh, options);
  options.solver = {{StretchElement::Membrane, BendElement::Morley, MassRule::Area},
                    {mu, lambda, d, nu, material.density * h, 1},
                    {},
                    {},
                    {}};
  Simulation solver(mesh, options);
  for (Simulation* body : {&shell, &solver}) {
    Positions velocities;
    for (const Vec3& p : mesh.positions) velocities.push_back({p.y * p.z, p.x, 0});
    body->setVelocities(velocities);
    for (int i = 0; i < 20; ++i) body->step(kJob);
  }
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_LT(length(shell.position(v) - solver.position(v)), 1e-4 * bounds(mesh).diagonal());
}

TEST(SimulatedSolvers, aShellWithoutBendingStiffnessMovesLikeAMembrane) {
  for (const double bend : {0.0, 1e-34}) {
    SimulatedSolver solver;
    solver.model = {StretchElement::Membrane, BendElement::Morley, MassRule::Area};
    solver.constants = {400, 300, bend, 0.3, 10, 1};
    Simulation body(shapes::grid(6, 6), optionsOf(solver, 20));
    body.setGravity({0, -9.81, 0});
    for (int i = 0; i < 5; ++i) body.step(kJob);
    EXPECT_TRUE(body.isFinite());
    EXPECT_LT(body.position(20).y, 0.99);
  }
}

std::string refusalOf(const SimulatedSolver& solver) {
  try {
    Simulation body(shapes::grid(2, 2), optionsOf(solver, 20));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SimulatedSolvers, whatDoesNotFitTheMeshIsRefusedWithASentence) {
  const SimulatedSolver good = panel().front();
  EXPECT_EQ(refusalOf(good), "");
  SimulatedSolver bad = good;
  bad.stretchFactors = {1, 2};
  EXPECT_NE(refusalOf(bad).find("The factors on stretching are 2, but the mesh needs 8"), std::string::npos);
  bad = good;
  bad.masses.assign(9, -1);
  EXPECT_NE(refusalOf(bad).find("The masses must be finite and above 0"), std::string::npos);
  bad = good;
  bad.constants.bend = -1;
  EXPECT_NE(refusalOf(bad).find("The bend constant"), std::string::npos);
  bad = good;
  bad.constants.unit = 0.5;
  EXPECT_NE(refusalOf(bad).find("different units"), std::string::npos);
}

}  // namespace
}  // namespace limber
