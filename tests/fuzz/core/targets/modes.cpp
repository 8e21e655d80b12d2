// Modes, guidance and the comparison of two bodies, with any material.

#include "compare/fidelity.h"
#include "fields/guidance.h"
#include "modes/find_modes.h"
#include "promises.h"
#include "simplify/simplify.h"
#include "soup.h"

namespace limber::fuzz {
namespace {

ElasticMaterial drawMaterial(FuzzInput& input) {
  ElasticMaterial material{1e6, 0.3, 1000, 0.01, 1};
  double* const fields[] = {&material.young, &material.poisson, &material.density, &material.thickness,
                            &material.unit};
  for (double* field : fields)
    if (input.chance(24))
      *field = static_cast<double>(input.anyFloat());
    else if (input.chance(64))
      *field *= std::pow(10, input.real(-6, 6));
  return material;
}

}  // namespace

void fuzzModes(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 60);
  ModesOptions options;
  options.model = static_cast<ElasticModel>(input.byte() % 4);
  options.modeCount = 1 + input.byte() % 6;
  options.material = drawMaterial(input);
  options.direction = static_cast<int>(input.byte() % 4) - 1;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (input.chance(16)) options.pinned.push_back(v);
  if (input.chance(64)) options.guidedParts = 1 + input.byte();
  Job job;
  const ModeSet modes = findModes(mesh, options, input.chance(128), job);
  requireFinite(modes.shapes, "the shape of a mode is finite");
  std::vector<double> omega(size_t{modes.modesPerComponent} * modes.components.size(), 0);
  for (const Mode& mode : modes.modes) {
    require(std::isfinite(mode.omega) && mode.omega >= 0, "a frequency is finite");
    omega[size_t{mode.component} * modes.modesPerComponent + mode.ordinal] = mode.omega;
  }
  GuidanceOptions guidance;
  for (uint32_t k = 0; k < modes.modesPerComponent; ++k) guidance.ordinals.push_back(k);
  guidance.p = input.chance(64) ? std::numeric_limits<double>::infinity() : input.real(1, 8);
  guidance.threshold = input.real(0, 1);
  if (modes.modesPerComponent > 0) {
    const StrainGuidance strain = strainGuidance(mesh, modes.shapes, omega, guidance, job);
    requireFinite(strain.rank, "the rank of a strain is finite");
  }
  if (input.chance(64)) {
    const History history = simplify(mesh, {}, {.method = Method::Qem}, job);
    const FidelityOptions asked{.modeCount = 2, .material = options.material};
    compareFidelity(mesh, meshAt(mesh, history, mesh.triangleCount() / 2).mesh, asked, job);
  }
}

}  // namespace limber::fuzz
