#include "modes/coarse_vibration.h"

#include <utility>
#include <vector>

#include "modes/coarse_part.h"

namespace limber {

ShellVibration coarseVibration(const TriangleMesh& mesh, const ShellMaterial& material,
                               const CoarseVibrationOptions& options, Job& job) {
  Part part;
  part.model = Model::Shell;
  part.mesh = mesh;
  part.pinned.assign(options.pinned.begin(), options.pinned.end());
  const CoarsePart coarse = coarsen(part, options.vertices, job);
  const TriangleMesh& copy = coarse.part.mesh;
  const Topology topology = buildTopology(copy);
  const VibratingShell shell(copy, topology, {.poisson = material.poisson, .pinned = coarse.part.pinned},
                             job);
  const ShellVibration found = shell.solve(copy, material.thickness, options.modeCount, job);
  const Prolongation prolongation(mesh, coarse);
  ShellVibration start{
      material.thickness, found.lambda,
      Eigen::MatrixXd(3 * static_cast<Eigen::Index>(mesh.vertexCount()), found.lambda.size())};
  std::vector<Vec3> shape(copy.vertexCount());
  for (Eigen::Index k = 0; k < found.lambda.size(); ++k) {
    job.check();
    for (size_t v = 0; v < shape.size(); ++v) {
      const auto row = 3 * static_cast<Eigen::Index>(v);
      shape[v] = {found.phi(row, k), found.phi(row + 1, k), found.phi(row + 2, k)};
    }
    const std::vector<Vec3> carried = prolongation.prolong(shape);
    for (size_t v = 0; v < carried.size(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        start.phi(3 * static_cast<Eigen::Index>(v) + axis, k) = carried[v][axis];
  }
  return start;
}

}  // namespace limber
