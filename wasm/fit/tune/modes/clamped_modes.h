#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "fit/tune/modes/clampings.h"
#include "fit/tune/modes/mode_matching.h"
#include "fit/tune/modes/tune_parts.h"

namespace limber {

struct TuneMasses {
  std::span<const double> original, result;  // kg per vertex of the bodies
};

// The modes of one part in one clamping: those of the original, and those of the result for any factors,
// matched to them.
class PartModesPair {
 public:
  // Refers to `pair`. `count`: modes of the original that are wanted.
  PartModesPair(const PartPair& pair, const PartPins& pins, const TuneMasses& masses, int count);

  // Finds the modes of the result with factors of 1, then those of the original, whose first eigenvalue is
  // near. Throws Cancelled, and std::runtime_error where memory is short.
  void solveResult(double scale, Job& job);
  void solveOriginal(Job& job);
  // Whether rigid motions alone meet no resistance on the result, and on the original, and their modes were
  // found: of the result for the factors of the last call.
  bool isDefinite() const { return status_ == FrequencyStatus::Found; }
  FrequencyStatus status() const { return status_; }

  // Modes of the result for other factors of its constraints, to about 1e-4 in eigenvalues. Where that leaves
  // it without enough of them, they stay as they were, so that they can be followed to better factors.
  void follow(std::span<const double> factors, Job& job);
  // The same part with other masses of the result, vertices of the body; its modes have to be followed.
  void setResultMasses(std::span<const double> masses);

  // Of the original, ascending; at most `count`.
  const Eigen::VectorXd& wanted() const { return wanted_; }
  // Of the result: the eigenvalue that stands for mode i of the original.
  double eigenvalue(size_t i) const { return modes_.lambda[partner_[i]]; }
  // The modes of the result that are nearly equal to that one, itself among them, and all modes.
  const ModeRange& clusterOf(size_t i) const;
  const ModeBasis& modes() const { return modes_; }
  double firstEigenvalue() const { return modes_.lambda[0]; }
  size_t pairIndex() const { return pairIndex_; }
  const PartPair& pair() const { return *pair_; }

 private:
  EigenSolution originalModes(Job& job) const;
  // Sets the status by what `find` finds with rigid motions of that number.
  template <typename Find>
  EigenSolution find(int rigidMotions, const Find& find);
  void match();

  const PartPair* pair_;
  size_t pairIndex_;
  int count_;
  SolverVibration original_, result_;
  FrequencyStatus status_ = FrequencyStatus::Found;
  ModeBasis modes_;  // of the result, some more than wanted
  Eigen::VectorXd wanted_;
  Eigen::MatrixXd expected_;  // T^T M phi of the original: its inner products with shapes of the result
  std::vector<Eigen::Index> partner_;
  std::vector<ModeRange> wantedClusters_, clusters_;  // of the original and of the result
};

// All parts in one clamping, their modes sorted together.
class ClampedModes {
 public:
  // One mode of the original.
  struct Wanted {
    size_t part, mode;  // of parts()
    double lambda;
  };

  ClampedModes(const std::deque<PartPair>& pairs, const Clamping& clamping, const TuneMasses& masses,
               int count);

  ClampKind kind() const { return kind_; }
  // Solves both bodies. `scales`: per part of the body a rough size of its first eigenvalue. Throws as
  // PartModesPair; stops early where the energy of a solver leaves motions without resistance.
  void solve(const std::vector<double>& scales, Job& job);
  bool isDefinite() const { return status() == FrequencyStatus::Found; }
  // That of the first part whose modes are not found, if there is one.
  FrequencyStatus status() const;

  // `factors`: per constraint of the result's body.
  void follow(std::span<const double> factors, Job& job);
  void setResultMasses(std::span<const double> masses);

  // The lowest modes of the original over all parts, ascending: at most the count.
  const std::vector<Wanted>& wanted() const { return wanted_; }
  // ln(lambda / lambda of the original) of mode i.
  double residual(size_t i) const;
  // Mean relative errors of frequencies of modes first .. last - 1 in %; NaN where the original has fewer.
  double meanError(size_t first, size_t last) const;
  const std::vector<PartModesPair>& parts() const { return parts_; }

 private:
  ClampKind kind_;
  size_t count_;
  std::vector<PartModesPair> parts_;
  std::vector<Wanted> wanted_;
};

}  // namespace limber
