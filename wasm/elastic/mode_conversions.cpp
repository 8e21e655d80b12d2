#include "elastic/mode_conversions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/parallel.h"
#include "elastic/mode_character.h"

namespace limber {

namespace {

void addPart(ModeSet& set, const Part& part, const PartModes& modes, double toRadians) {
  const size_t vertexCount = set.shapes.size() / (3 * std::max<size_t>(1, set.modesPerComponent));
  const ModeObserver observer(part.mesh);
  const auto modeCount = static_cast<uint32_t>(modes.basis.modeCount());
  const size_t first = set.modes.size();
  set.modes.resize(first + modeCount);
  parallelFor(modeCount, 1, [&](size_t begin, size_t end) {
    for (auto ordinal = static_cast<uint32_t>(begin); ordinal < end; ++ordinal) {
      const auto shape = modes.basis.phi.col(ordinal);
      set.modes[first + ordinal] = {std::sqrt(modes.basis.lambda[ordinal]) * toRadians,
                                    modes.residual[ordinal],
                                    part.components[0],
                                    ordinal,
                                    modes.axis[ordinal],
                                    nameOf(observer.observe(shape))};
      for (size_t v = 0; v < part.vertexOfBody.size(); ++v)
        for (size_t c = 0; c < 3; ++c)
          set.shapes[(ordinal * vertexCount + part.vertexOfBody[v]) * 3 + c] =
              static_cast<float>(shape[static_cast<Eigen::Index>(3 * v + c)]);
    }
  });
  for (uint32_t component : part.components) {
    ComponentModes& entry = set.components[component];
    entry.model = part.model;
    entry.host = part.components[0];
    entry.modeCount = modeCount;
    entry.coarseVertices = modes.coarseVertices;
    entry.failure = modes.failure;
    if (component != entry.host) continue;
    entry.zeroModesExpected = modes.zeroModesExpected;
    entry.zeroModesFound = modes.zeroModesFound;
  }
  for (const Triangle& t : part.mesh.triangles) ++set.components[part.componentOfVertex[t[0]]].faces;
  set.factorNonzeros = std::max(set.factorNonzeros, modes.factorNonzeros);
}

}  // namespace

ModeSet collectModes(const TriangleMesh& body, const std::vector<Part>& parts,
                     const std::vector<PartModes>& modes, const ModesOptions& options) {
  ModeSet set;
  size_t componentCount = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    componentCount += parts[i].components.size();
    set.modesPerComponent =
        std::max(set.modesPerComponent, static_cast<uint32_t>(modes[i].basis.modeCount()));
  }
  set.components.resize(componentCount);
  set.shapes.assign(3 * size_t{body.vertexCount()} * set.modesPerComponent, 0.0f);
  const ElasticMaterial& material = options.material;
  for (size_t i = 0; i < parts.size(); ++i) {
    // In the frame, E, rho and the diagonal are 1: omega = omega_frame sqrt(E / rho) / L.
    const double toRadians =
        std::sqrt(material.young / material.density) / (parts[i].diagonal * material.unit);
    addPart(set, parts[i], modes[i], toRadians);
  }
  for (const Mode& mode : set.modes)
    if (!std::isfinite(mode.omega))
      throw std::invalid_argument(
          "Young's modulus, density and unit give infinite frequencies: choose those of a real material.");
  std::stable_sort(set.modes.begin(), set.modes.end(),
                   [](const Mode& a, const Mode& b) { return a.omega < b.omega; });
  return set;
}

ModeBasis lowestModes(const ModeSet& set, std::span<const uint32_t> componentOfVertex, size_t count) {
  const size_t vertexCount = componentOfVertex.size(), listed = std::min(set.modes.size(), count);
  const auto columns = static_cast<Eigen::Index>(listed);
  ModeBasis basis{Eigen::VectorXd(columns),
                  Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(vertexCount), columns)};
  for (size_t k = 0; k < listed; ++k) {
    const Mode& mode = set.modes[k];
    const auto column = static_cast<Eigen::Index>(k);
    basis.lambda[column] = mode.omega * mode.omega;
    for (size_t v = 0; v < vertexCount; ++v)
      if (componentOfVertex[v] == mode.component)
        for (size_t c = 0; c < 3; ++c)
          basis.phi(static_cast<Eigen::Index>(3 * v + c), column) =
              set.shapes[(mode.ordinal * vertexCount + v) * 3 + c];
  }
  return basis;
}

}  // namespace limber
