#pragma once

#include <Eigen/Core>
#include <vector>

namespace limber {

// The one-to-one pairing of rows with columns that has the largest total value: the column of each row, or -1
// for a row without a partner, if there are more rows than columns. Hungarian method (Kuhn 1955) by shortest
// augmenting paths, O(n^3). Values must be finite.
std::vector<int> assign(const Eigen::MatrixXd& value);

}  // namespace limber
