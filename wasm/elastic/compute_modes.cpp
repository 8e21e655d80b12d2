#include <stdexcept>

#include "elastic/mode_conversions.h"
#include "elastic/modes.h"
#include "elastic/part_modes.h"
#include "mesh/topology.h"

namespace limber {

void checkModesOptions(const TriangleMesh& mesh, const ModesOptions& options) {
  const auto require = [](bool isMet, const char* sentence) {
    if (!isMet) throw std::invalid_argument(sentence);
  };
  const ElasticMaterial& material = options.material;
  require(options.modeCount >= 1, "The number of modes must be at least 1.");
  require(material.thickness > 0, "The thickness must be larger than 0.");
  require(material.young > 0 && material.density > 0, "Young's modulus and density must be larger than 0.");
  require(material.poisson > -1 && material.poisson < 0.5, "Poisson's ratio must lie between -1 and 0.5.");
  require(material.unit > 0, "The unit must be a positive number of metres.");
  require(options.direction >= -1 && options.direction <= 2, "The direction must be x, y or z.");
  require(!mesh.triangles.empty(), "The mesh has no usable triangle, so it has no modes.");
}

ModeSet computeModes(const TriangleMesh& mesh, const ModesOptions& options, Job& job) {
  checkModesOptions(mesh, options);
  const std::vector<Part> parts = partsOf(mesh, buildTopology(mesh), options);
  std::vector<PartModes> modes;
  for (const Part& part : parts) modes.push_back(solvePart(part, options, job));
  return collectModes(mesh, parts, modes, options);
}

}  // namespace limber
