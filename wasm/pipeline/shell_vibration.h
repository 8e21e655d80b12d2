#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/job.h"
#include "modes/parts.h"
#include "modes/shell_sensitivity.h"

namespace limber {

// Elastic modes of a free shell in a frame where E = rho = 1. phi: unknowns x modes, mass-normalised; its
// first 3 x vertexCount rows are displacements, and the rest may be 0 in a start.
struct ShellVibration {
  double thickness = 0;
  Eigen::VectorXd lambda;
  Eigen::MatrixXd phi;
};

// The lowest `count` modes. With `start`, a vibration of nearly the same mesh (same triangles) or of the same
// mesh at another thickness, by inverse iteration from that, which finds what the start approximates.
ShellVibration vibrate(const TriangleMesh& mesh, const Topology& topology, const ShellMaterial& material,
                       int count, const ShellVibration* start, Job& job);

}  // namespace limber
