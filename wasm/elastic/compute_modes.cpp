#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "elastic/mode_character.h"
#include "elastic/modes.h"
#include "elastic/part_modes.h"
#include "mesh/topology.h"

namespace limber {

namespace {

void addPart(ModeSet& set, const Part& part, const PartModes& modes, double toRadians) {
  const size_t vertexCount = set.shapes.size() / (3 * std::max<size_t>(1, set.modesPerComponent));
  const ModeObserver observer(part.mesh);
  for (uint32_t ordinal = 0; ordinal < modes.omega.size(); ++ordinal) {
    const std::vector<Vec3>& shape = modes.shapes[ordinal];
    set.modes.push_back({modes.omega[ordinal] * toRadians, modes.residual[ordinal], part.components[0],
                         ordinal, modes.axis[ordinal], nameOf(observer.observe(shape))});
    for (size_t v = 0; v < part.vertexOfBody.size(); ++v)
      for (int c = 0; c < 3; ++c)
        set.shapes[(ordinal * vertexCount + part.vertexOfBody[v]) * 3 + static_cast<size_t>(c)] =
            static_cast<float>(shape[v][c]);
  }
  for (uint32_t component : part.components) {
    ComponentModes& entry = set.components[component];
    entry.model = part.model;
    entry.host = part.components[0];
    entry.modeCount = static_cast<uint32_t>(modes.omega.size());
    entry.coarseVertices = modes.coarseVertices;
    if (component != entry.host) continue;
    entry.zeroModesExpected = modes.zeroModesExpected;
    entry.zeroModesFound = modes.zeroModesFound;
  }
  for (const Triangle& t : part.mesh.triangles) ++set.components[part.componentOfVertex[t[0]]].faces;
  set.factorNonzeros = std::max(set.factorNonzeros, modes.factorNonzeros);
}

}  // namespace

void checkModesOptions(const TriangleMesh& mesh, const ModesOptions& options) {
  const auto require = [](bool holds, const char* sentence) {
    if (!holds) throw std::invalid_argument(sentence);
  };
  require(options.modeCount >= 1, "The number of modes must be at least 1.");
  require(options.thickness > 0, "The thickness must be larger than 0.");
  require(options.young > 0 && options.density > 0, "Young's modulus and density must be larger than 0.");
  require(options.poisson > -1 && options.poisson < 0.5, "Poisson's ratio must lie between -1 and 0.5.");
  require(options.unit > 0, "The unit must be a positive number of metres.");
  require(options.direction >= -1 && options.direction <= 2, "The direction must be x, y or z.");
  require(!mesh.triangles.empty(), "The mesh has no usable triangle, so it has no modes.");
}

ModeSet collectModes(const TriangleMesh& body, const std::vector<Part>& parts,
                     const std::vector<PartModes>& modes, const ModesOptions& options) {
  ModeSet set;
  size_t componentCount = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    componentCount += parts[i].components.size();
    set.modesPerComponent = std::max(set.modesPerComponent, static_cast<uint32_t>(modes[i].omega.size()));
  }
  set.components.resize(componentCount);
  set.shapes.assign(3 * size_t{body.vertexCount()} * set.modesPerComponent, 0.0f);
  for (size_t i = 0; i < parts.size(); ++i) {
    // In the frame E, rho and the diagonal are 1: omega = omega_frame sqrt(E / rho) / L.
    const double toRadians = std::sqrt(options.young / options.density) / (parts[i].diagonal * options.unit);
    addPart(set, parts[i], modes[i], toRadians);
  }
  std::stable_sort(set.modes.begin(), set.modes.end(),
                   [](const Mode& a, const Mode& b) { return a.omega < b.omega; });
  return set;
}

ModeSet computeModes(const TriangleMesh& mesh, const ModesOptions& options, Job& job) {
  checkModesOptions(mesh, options);
  const std::vector<Part> parts = partsOf(mesh, buildTopology(mesh), options);
  std::vector<PartModes> modes;
  for (const Part& part : parts) modes.push_back(solvePart(part, options, job));
  return collectModes(mesh, parts, modes, options);
}

}  // namespace limber
