#pragma once

#include <Eigen/Core>
#include <vector>

#include "elastic/shell_sensitivity.h"
#include "fit/target/mismatch.h"

namespace limber {

// Modes phi of a mesh after a rotation R within neighbourhoods of frequencies, psi = phi R, that brings each
// as close as possible to its partner among the modes of the original. Modes of nearly the same frequency
// are unique only up to a rotation; compared one by one they would move vertices for nothing.
struct AlignedModes {
  Eigen::MatrixXd rotation;   // R: a row for each mode of the mesh, a column for each of the original
  Eigen::MatrixXd stiffness;  // psi^T K psi
  Eigen::VectorXd weight;     // per mode of the original; 0 where the mesh has no mode like it
};

// `lambda`: eigenvalues of the mesh. `overlap(j, i)`: inner product of the mass-normalised mode j of the mesh
// and mode i of the original. `wanted`: eigenvalues of the original. `thicknessWeight`: what every mode
// counts at this thickness. R is the polar factor of the overlaps within neighbourhoods. A mode's weight
// rises from 0 where its neighbourhood captures 0.2 of its squared norm to its whole at 0.6.
AlignedModes alignModes(const Eigen::VectorXd& lambda, const Eigen::MatrixXd& overlap,
                        const Eigen::VectorXd& wanted, double thicknessWeight);

// The entries of psi^T K psi that count, and what each is multiplied by to become a residual.
struct ResidualEntries {
  std::vector<ModePair> pairs;
  std::vector<double> scale;
};

// Fills in all of `mismatch` but the Jacobian. `coupling`: weight of the entries off the diagonal; only those
// between neighbouring frequencies count.
ResidualEntries findResiduals(const AlignedModes& aligned, const Eigen::VectorXd& wanted, double coupling,
                              Mismatch& mismatch);

}  // namespace limber
