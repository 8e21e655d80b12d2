#pragma once

#include <Eigen/Core>
#include <vector>

#include "elastic/shell_sensitivity.h"
#include "fit/target/mismatch.h"

namespace limber {

// Modes phi of a mesh after a rotation R within neighbourhoods of frequencies, psi = phi R, that brings each
// as close as possible to its partner among the modes of the original. Eigensolvers return modes of nearly
// the same frequency in arbitrary mixtures; compared one by one, these would move vertices for nothing.
struct AlignedModes {
  Eigen::MatrixXd rotation;   // R: a row for each mode of the mesh, a column for each of the original
  Eigen::MatrixXd stiffness;  // psi^T K psi
  Eigen::VectorXd weight;     // per mode of the original; 0 if the mesh has no similar mode
};

// `lambda`: eigenvalues of the mesh. `overlap(j, i)`: inner product of the mass-normalised mode j of the mesh
// and mode i of the original. `wanted`: eigenvalues of the original. `thicknessWeight`: the weight of every
// mode at this thickness. R is the polar factor of the overlaps within neighbourhoods. The weight of a mode
// rises from 0 if its neighbourhood captures 0.2 of its squared norm to the full weight at 0.6.
AlignedModes alignModes(const Eigen::VectorXd& lambda, const Eigen::MatrixXd& overlap,
                        const Eigen::VectorXd& wanted, double thicknessWeight);

// The entries of psi^T K psi that count, and the factor that makes each a residual.
struct ResidualEntries {
  std::vector<ModePair> pairs;
  std::vector<double> scale;
};

// Fills in all of `mismatch` but the Jacobian. `coupling`: weight of the off-diagonal entries, of which only
// those between neighbouring frequencies count.
ResidualEntries findResiduals(const AlignedModes& aligned, const Eigen::VectorXd& wanted, double coupling,
                              Mismatch& mismatch);

}  // namespace limber
