#pragma once

#include <Eigen/Core>
#include <vector>

namespace limber {

// Modes first .. last - 1.
struct ModeRange {
  Eigen::Index first, last;
};

// Groups ascending eigenvalues, all above 0, into clusters of nearly equal ones: within 1 % of the first of
// their cluster, half a percent in frequency. The shapes of modes in a cluster come in arbitrary mixtures, so
// that only quantities that depend on their span are meaningful.
std::vector<ModeRange> modeClusters(const Eigen::VectorXd& lambda);

// The mode of a coarse mesh that corresponds to each mode of the original. `overlap(j, i)`: inner product in
// the mass of the mass-normalised mode j of the coarse mesh and mode i of the original; both ascend by their
// eigenvalues, and the coarse mesh has at least as many. `clusters`: of the modes of the original.
//
// A mode that shares more than half of its squared norm (MAC) with the span of a cluster is matched to a mode
// of that cluster, whatever its own position in the spectrum: of several those that share most, in ascending
// order. All others follow in ascending order. The result does not depend on the mixture in which the modes
// of a cluster come.
std::vector<Eigen::Index> matchModes(const Eigen::MatrixXd& overlap, const std::vector<ModeRange>& clusters);

}  // namespace limber
