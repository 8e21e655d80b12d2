// Tunes coarse meshes to their originals with every solver model and prints the errors of frequencies as
// Markdown:
//
//   tune_panel [--faces 0.25] [--solvers springs,dihedral] [--kinds global,constraint] [--trial] [--pins 6]
//     MESH.obj...
//
// With `--trial` both bodies also move; `--pins P` pins the lowest P % along the longest side of the box. The
// last columns tell the seconds and why nothing moved.
//
// Untouched parameters are those of one thin shell, typed in again on the coarse mesh: thickness 2 % of the
// diagonal, Poisson's ratio 0.3; springs across have a twentieth of the stiffness of edges.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "../../core/shared_meshes.h"
#include "base/parallel.h"
#include "fit/tune/tune_solver.h"
#include "mesh/quality.h"
#include "mesh/repair/weld.h"
#include "simplify/simplify.h"
#include "transfer/carry_pins.h"

using namespace limber;

namespace {

struct Solver {
  const char* name;
  SolverModel model;
};

constexpr Solver kSolvers[] = {
    {"shell", {StretchElement::Membrane, BendElement::Morley, MassRule::Area}},
    {"hinge-shell", {StretchElement::Membrane, BendElement::HingeByArea, MassRule::Area}},
    {"mujoco", {StretchElement::Membrane, BendElement::HingeByArea, MassRule::Vertex}},
    {"newton", {StretchElement::Membrane, BendElement::HingeByLength, MassRule::Area}},
    {"dihedral", {StretchElement::EdgeSprings, BendElement::Hinge, MassRule::Area}},
    {"springs", {StretchElement::EdgeSprings, BendElement::CrossSprings, MassRule::Area}},
};

constexpr const char* kKinds[] = {"global", "vertex", "constraint"};

struct Arguments {
  double faces = 0.25;
  double pinShare = 0;  // of the longest side
  bool runsTrial = false;
  std::string solvers, kinds;
  std::vector<std::string> files;
};

Arguments parse(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string value = values[i];
    if (value == "--faces" && i + 1 < count)
      arguments.faces = std::atof(values[++i]);
    else if (value == "--pins" && i + 1 < count)
      arguments.pinShare = std::atof(values[++i]) / 100;
    else if (value == "--solvers" && i + 1 < count)
      arguments.solvers = "," + std::string(values[++i]) + ",";
    else if (value == "--trial")
      arguments.runsTrial = true;
    else if (value == "--kinds" && i + 1 < count)
      arguments.kinds = "," + std::string(values[++i]) + ",";
    else
      arguments.files.push_back(value);
  }
  return arguments;
}

bool isChosen(const std::string& list, const char* name) {
  return list.empty() || list.find("," + std::string(name) + ",") != std::string::npos;
}

SolverConstants constantsOf(const SolverModel& model, const TriangleMesh& original) {
  const double young = 1e6, poisson = 0.3, density = 1000, thickness = 0.02 * bounds(original).diagonal();
  const double plane = young * thickness / (1 - poisson * poisson), d = plane * thickness * thickness / 12;
  SolverConstants constants;
  constants.poisson = poisson;
  constants.surfaceDensity = density * thickness;
  constants.stretch = plane * (1 - poisson) / 2;
  constants.secondStretch = plane * poisson;
  if (model.stretch == StretchElement::EdgeSprings) constants.stretch = 0.866 * young * thickness;
  constants.bend = d;
  if (model.mass == MassRule::Vertex) constants.bend = d / 3;  // a flex of MuJoCo bends so much more easily
  if (model.bend == BendElement::Hinge) constants.bend = 3.46 * d;
  if (model.bend == BendElement::HingeByLength) constants.bend = 3.46 * d / meanSide(original);
  if (model.bend == BendElement::CrossSprings) constants.bend = 0.05 * constants.stretch;
  return constants;
}

// "untouched -> tuned (noise floor), what is kept", % of the diagonal, or why there is none.
std::string motionOf(const Tuned& tuned) {
  if (!tuned.motion) return tuned.motionRefusal;
  char text[120];
  std::snprintf(text, sizeof text, "%s %.3f -> %.3f (%.3f), %s", tuned.motion->scene.c_str(),
                tuned.motion->untouched, tuned.motion->tuned, tuned.motion->noiseFloor,
                tuned.motion->kept == KeptParameters::Tuned ? "tuned" : "untouched");
  return text;
}

std::vector<uint32_t> lowestVertices(const TriangleMesh& mesh, double share) {
  const Bounds box = bounds(mesh);
  int axis = 0;
  for (int c = 1; c < 3; ++c)
    if (box.high[c] - box.low[c] > box.high[axis] - box.low[axis]) axis = c;
  std::vector<uint32_t> vertices;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v][axis] <= box.low[axis] + share * (box.high[axis] - box.low[axis]))
      vertices.push_back(v);
  return vertices;
}

void measure(const std::string& file, const Arguments& arguments, Job& job) {
  const shared_meshes::Soup soup = shared_meshes::readObj(file);
  const TriangleMesh original = weld(soup.positions, soup.indices, {}, job).mesh;
  const auto faces = static_cast<uint32_t>(arguments.faces * original.triangleCount());
  const TriangleMesh coarse =
      meshAt(original, simplify(original, {}, {.method = Method::Limber}, job), faces).mesh;
  const std::string name = std::filesystem::path(file).stem().string();
  for (const Solver& solver : kSolvers)
    for (int kind = 0; kind < 3; ++kind) {
      if (!isChosen(arguments.solvers, solver.name) || !isChosen(arguments.kinds, kKinds[kind])) continue;
      TuneOptions options;
      options.model = solver.model;
      options.original = options.result = constantsOf(solver.model, original);
      options.tune = static_cast<TuneKind>(kind);
      options.runsTrial = arguments.runsTrial;
      if (arguments.pinShare > 0) {
        options.pinnedOriginal = lowestVertices(original, arguments.pinShare);
        options.pinnedResult = carryPins(original, options.pinnedOriginal, coarse).vertices;
      }
      const auto start = std::chrono::steady_clock::now();
      try {
        const Tuned tuned = tuneSolver(original, coarse, options, job);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::printf("| %s | %s | %s | %.2f | %.2f | %.2f | %.2f | %.3f %.3f | %s | %.1f s |\n", name.c_str(),
                    solver.name, kKinds[kind], tuned.frequencies.errorUntouched, tuned.frequencies.errorTuned,
                    tuned.frequencies.errorUnseen, tuned.frequencies.errorOtherPins, tuned.stretchFactor,
                    tuned.bendFactor, motionOf(tuned).c_str(), seconds.count());
      } catch (const std::exception& error) {
        std::printf("| %s | %s | %s | %s |\n", name.c_str(), solver.name, kKinds[kind], error.what());
      }
      std::fflush(stdout);
    }
}

}  // namespace

int main(int count, char** values) {
  setThreadCount(2);
  Job job;
  const Arguments arguments = parse(count, values);
  std::printf(
      "| mesh | solver | tuned | untouched | tuned | modes 21-30 | other clamping | factors | motion | time "
      "|\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& file : arguments.files) measure(file, arguments, job);
}
