#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "elastic/solvers/solver_model.h"

namespace limber {

// Global: one factor for each kind of constraint. Vertex: smooth fields per vertex times these. Constraint: a
// factor for each constraint.
enum class TuneKind : int32_t { Global = 0, Vertex = 1, Constraint = 2 };

struct TuneOptions {
  SolverModel model;
  // The constants to which the user's own parameters correspond on the original, and on the untuned coarse
  // mesh.
  SolverConstants original, result;
  std::vector<uint32_t> pinnedOriginal, pinnedResult;  // vertices; both may be empty
  TuneKind tune = TuneKind::Global;
  MassRule tunedMass = MassRule::Area;  // Area: carried over from the original. Vertex: the same for all
  bool runsTrial = false;               // whether a motion trial runs before factors are returned
};

// Whether a body has frequencies that can be tuned. NoResistance: the solver's energy leaves motions other
// than rigid ones without resistance. NoConvergence: no search found its modes, which implies nothing about
// its stiffness.
enum class FrequencyStatus : int32_t { Found = 0, NoResistance = 1, NoConvergence = 2 };

// Mean relative errors of frequencies in %; NaN if a body has no such modes.
struct TunedFrequencies {
  double errorUntouched = std::numeric_limits<double>::quiet_NaN();  // modes 1 to 10, free
  double errorTuned = std::numeric_limits<double>::quiet_NaN();
  double errorUnseen = std::numeric_limits<double>::quiet_NaN();  // modes 21 to 30, tuned
  // Modes 1 to 10 of the body clamped at the end that was not fitted, tuned.
  double errorOtherPins = std::numeric_limits<double>::quiet_NaN();
};

enum class KeptParameters : int32_t { Tuned = 0, Untouched = 1 };

// Deviations in % of the diagonal, see compare/motion_deviation.h. Differences up to the noise floor are not
// significant.
struct TunedMotion {
  std::string scene;
  double untouched = 0, tuned = 0, noiseFloor = 0;
  KeptParameters kept = KeptParameters::Tuned;
};

// The parameters with which a solver moves a coarse mesh like the original. Constraints are those of
// SolverStiffness in its order.
struct Tuned {
  double stretchFactor = 1, bendFactor = 1;         // on TuneOptions::result
  std::vector<double> stretchField, bendField;      // Vertex: per vertex, mean 1; else empty
  std::vector<double> stretchFactors, bendFactors;  // Constraint: per constraint of its kind; else empty
  std::vector<double> masses;                       // kg per vertex; their sum is the mass of the original
  std::vector<uint32_t> stretchVertices, bendVertices;  // of each constraint, one after the other
  TunedFrequencies frequencies;
  FrequencyStatus frequencyStatus = FrequencyStatus::Found;
  KeptParameters kept = KeptParameters::Tuned;  // untouched: factors are 1, only masses are tuned
  std::optional<TunedMotion> motion;
  std::string motionRefusal;  // why there is no `motion` although requested, as a clause; else empty
};

}  // namespace limber
