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

// What is known of a part from clampings that were solved before.
struct PartHints {
  double firstEigenvalue = 0;  // a rough estimate; 0: unknown
  FactorSharing sharing;       // of the original in all clampings
};

// The modes of one part in one clamping: those of the original, and the matching ones of the result for any
// factors.
class PartModesPair {
 public:
  // Keeps a reference to `pair`. `count`: wanted modes of the original.
  PartModesPair(const PartPair& pair, const PartPins& pins, const TuneMasses& masses, int count);

  // Finds the modes of the result with factors of 1, then those of the original, whose first eigenvalue is
  // close. Throws Cancelled, and std::runtime_error if memory is short.
  void solveResult(double scale, Job& job);
  void solveOriginal(FactorSharing& sharing, Job& job);
  // Whether the modes of the result and of the original were found, and no motions but rigid ones are without
  // resistance; for the result with the factors of the last call.
  bool isDefinite() const { return status_ == FrequencyStatus::Found; }
  FrequencyStatus status() const { return status_; }

  // Finds the modes of the result for other factors of its constraints: the partners of the first `count`
  // modes of the original, at most all, to about 1e-4 in eigenvalues. If too few are found, the previous ones
  // are kept, so that they can be tracked to better factors.
  void follow(std::span<const double> factors, int count, Job& job);
  // The same part with other masses of the result, per vertex of the body; its modes have yet to be tracked.
  void setResultMasses(std::span<const double> masses);

  // Of the original, ascending; at most `count`.
  const Eigen::VectorXd& wanted() const { return wanted_; }
  // Of the result: the eigenvalue that corresponds to mode i of the original.
  double eigenvalue(size_t i) const { return modes_.lambda[partner_[i]]; }
  // The range of modes of the result with nearly the same eigenvalue as that one, which is included; and all
  // modes.
  const ModeRange& clusterOf(size_t i) const;
  const ModeBasis& modes() const { return modes_; }
  double firstEigenvalue() const { return modes_.lambda[0]; }
  size_t pairIndex() const { return pairIndex_; }
  const PartPair& pair() const { return *pair_; }
  const std::vector<uint32_t>& clampedUnknowns() const { return original_.clampedUnknowns(); }

 private:
  EigenSolution originalModes(FactorSharing& sharing, Job& job) const;
  // Sets the status from the result of `find` for this number of rigid motions.
  template <typename Find>
  EigenSolution find(int rigidMotions, const Find& find);
  void match();

  const PartPair* pair_;
  size_t pairIndex_;
  int count_;
  SolverVibration original_, result_;
  FrequencyStatus status_ = FrequencyStatus::Found;
  ModeBasis modes_;  // of the result, a few more than wanted
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
  // Solves both bodies. `hints`: per part of the body. Throws as PartModesPair; stops early if the energy of
  // a solver leaves motions without resistance.
  void solve(std::vector<PartHints>& hints, Job& job);
  bool isDefinite() const { return status() == FrequencyStatus::Found; }
  // The status of the first part whose modes are not found, if there is one.
  FrequencyStatus status() const;

  // `factors`: per constraint of the result's body. Only the first `count` modes have to be exact.
  void follow(std::span<const double> factors, int count, Job& job);
  void follow(std::span<const double> factors, Job& job) { follow(factors, static_cast<int>(count_), job); }
  void setResultMasses(std::span<const double> masses);

  // The lowest modes of the original over all parts, ascending: at most the count.
  const std::vector<Wanted>& wanted() const { return wanted_; }
  // ln(lambda / lambda of the original) of mode i.
  double residual(size_t i) const;
  // Mean relative errors of frequencies of modes first .. last - 1 in %; NaN if the original has fewer.
  double meanError(size_t first, size_t last) const;
  const std::vector<PartModesPair>& parts() const { return parts_; }

 private:
  ClampKind kind_;
  size_t count_;
  std::vector<PartModesPair> parts_;
  std::vector<Wanted> wanted_;
};

}  // namespace limber
