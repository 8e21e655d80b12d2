#include "pipeline/shell_vibration.h"

#include "modes/eigensolver.h"
#include "modes/shell.h"

namespace limber {

namespace {

constexpr int kSpareModes = 6;  // the subspace converges by the first one left out
constexpr int kRigidMotions = 6;
constexpr int kFewUnknowns = 400;  // solved from scratch in no time

void addRigidMotions(const TriangleMesh& mesh, Eigen::MatrixXd& columns) {
  const Vec3 middle = 0.5 * (bounds(mesh).low + bounds(mesh).high);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions[v] - middle;
    columns.block<3, kRigidMotions>(3 * static_cast<Eigen::Index>(v), 0) << 1, 0, 0, 0, p.z, -p.y, 0, 1, 0,
        -p.z, 0, p.x, 0, 0, 1, p.y, -p.x, 0;
  }
}

EigenPairs continueFrom(const StiffnessModel& model, const TriangleMesh& mesh, const ShellVibration& start,
                        int count, double thickness, Job& job) {
  Eigen::MatrixXd columns(model.unknownCount(), kRigidMotions + start.phi.cols());
  columns.leftCols<kRigidMotions>().setZero();
  addRigidMotions(mesh, columns);
  columns.bottomRightCorner(model.unknownCount() - start.phi.rows(), start.phi.cols()).setZero();
  columns.topRightCorner(start.phi.rows(), start.phi.cols()) = start.phi;
  RefineOptions refine;
  // Bending has lambda ~ h^2.
  refine.shift = -0.5 * start.lambda[0] * (thickness * thickness) / (start.thickness * start.thickness);
  refine.elasticCount = count;
  return refineEigenpairs(model, columns, refine, job);
}

}  // namespace

ShellVibration vibrate(const TriangleMesh& mesh, const Topology& topology, const ShellMaterial& material,
                       int count, const ShellVibration* start, Job& job) {
  const StiffnessModel model = shellModel(mesh, topology, material.thickness, material.poisson);
  const double scale = 300 * material.thickness * material.thickness;  // as in modes/part_modes.cpp
  const bool continues = start && start->lambda.size() > 0 && model.unknownCount() > kFewUnknowns;
  const EigenPairs pairs =
      continues ? continueFrom(model, mesh, *start, count + kSpareModes, material.thickness, job)
                : solveEigenproblem(model, {count + kSpareModes, kRigidMotions, scale}, job);
  return {material.thickness, pairs.lambda, pairs.phi};
}

}  // namespace limber
