#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

#include "base/job.h"
#include "fit/tune/modes/clamped_modes.h"

namespace limber {

inline constexpr int kJudgedModes = 10;  // the first ones, whose mean error is reported

struct TuneSetup {
  const std::deque<PartPair>& pairs;
  std::vector<Clamping> clampings;  // the free one first
  TuneMasses masses;
  size_t constraintCount;  // of the result's body
};

// The factors on the constraints of a coarse mesh, and the resulting errors of its modes with respect to the
// original: 20 free modes, 8 of the body clamped at its lower end and 10 of the body pinned by the user are
// fitted; free modes 21 to 30 and 10 of the body clamped at its other end are not.
class TuneProblem {
 public:
  // Solves both bodies with factors of 1. Keeps references to the pairs. Throws Cancelled, and
  // std::runtime_error if memory is short.
  TuneProblem(const TuneSetup& setup, Job& job);

  // Whether all motions but rigid ones meet resistance, and the modes were found. While a problem is not
  // definite, nothing else may be called than moving it to factors for which it is.
  bool isDefinite() const { return status() == FrequencyStatus::Found; }
  FrequencyStatus status() const;

  // Sets the factors per constraint of the result's body, > 0, and tracks the fitted modes to them. Throws
  // Cancelled.
  void moveTo(const std::vector<double>& factors, Job& job);
  const std::vector<double>& factors() const { return factors_; }

  // ln(lambda / lambda of the original) of the fitted modes.
  Eigen::VectorXd residuals() const;
  // Their exact derivatives with respect to the logarithms of the factors: fitted modes x constraints of the
  // body. For modes of the result with nearly equal eigenvalues it is the mean of their derivatives, which
  // does not depend on the mixture that a solver finds.
  Eigen::MatrixXd jacobian() const;
  // Mean relative error of the fitted frequencies in %.
  double fittedError() const;

  // Mean errors in %, see TunedFrequencies. `otherPinsError` first tracks a copy of those modes to the
  // current factors.
  double freeError() const { return clampings_[0].meanError(0, kJudgedModes); }
  double unseenError() const { return clampings_[0].meanError(20, 30); }
  double otherPinsError(Job& job) const;
  // freeError() for other masses of the result and factors of 1. Leaves the problem unchanged.
  double freeErrorWith(std::span<const double> masses, Job& job) const;

 private:
  std::vector<ClampedModes> clampings_;  // the free ones first
  std::vector<double> factors_;
};

}  // namespace limber
