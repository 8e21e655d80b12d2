#pragma once

#include <Eigen/Core>
#include <vector>

namespace limber {

// A one-to-one pairing of rows with columns of the largest total value (Kuhn 1955, by shortest augmenting
// paths): the column of each row, or -1 where there are fewer columns than rows. O(n^3). Values must be
// finite.
std::vector<int> assign(const Eigen::MatrixXd& value);

}  // namespace limber
