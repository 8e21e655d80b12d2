#pragma once

#include <Eigen/Core>
#include <vector>

namespace limber {

// The mode of a coarse mesh that stands for each mode of the original. `overlap(j, i)`: inner product in the
// mass of the mass-normalised mode j of the coarse mesh and mode i of the original; both ascend by their
// eigenvalues, and the coarse mesh has at least as many. A mode that shares more than half of its squared
// norm (MAC) with one mode takes that one, wherever it stands; all others follow in ascending order, because
// modes of nearly the same frequency come in any mixture.
std::vector<Eigen::Index> matchModes(const Eigen::MatrixXd& overlap);

}  // namespace limber
