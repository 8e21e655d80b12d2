#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/job.h"
#include "fit/tune/moving_body.h"

namespace limber {

// A trial of the motion itself, before tuned parameters are handed over: the original moves through one or
// two short scenes in our own implementation of a solver, and other bodies are compared with it.
//
// Scenes: `sway` for a closed body: the lower end of the longest side is pinned, and the rest starts across
// it with a velocity that grows with the square of the height, so that the swing peaks near 4 % of the
// diagonal whatever the stiffness. `hang` for an open one: it falls under gravity along -y from the pins of
// the user, or from the upper end of its longest side. A closed body with pins of the user gets both.
//
// Springs, hinges and membranes move by the implicit steps of ImplicitMotion, and the shell with Morley's
// element by the XPBD of simulate/simulation.h, whose substeps are of first order. With hinges an
// AreaBarrier keeps triangles from losing their area. An original of more than 20,000 faces is not tried,
// one of cross springs not above 10,000, because that takes more than about a minute.
//
// A scene lasts for one and a half periods of the motion itself: of the lowest frequency that carries a
// noticeable share of the energy of the swing, and for `hang` of that joined with a pendulum's.
class MotionTrial {
 public:
  // Moves the original twice; it must outlive this object with all that it refers to. Throws Cancelled, and
  // std::invalid_argument as SolverConstraints does.
  MotionTrial(const MovingBody& original, const SolverModel& model, Job& job);
  ~MotionTrial();
  MotionTrial(MotionTrial&&) noexcept;
  MotionTrial& operator=(MotionTrial&&) noexcept;

  // Why there is no trial, as a clause; empty if there is one.
  const std::string& refusal() const;
  // 'sway', 'hang', or 'sway and hang'.
  std::string scene() const;

  // Mean motion deviation of another mesh of the same body in % of the diagonal of the original, see
  // compare/motion_deviation.h: over points, steps and scenes. Pins of the user are those of `body`, those of
  // `sway` are carried over. Nothing if there is no trial, or if the solver of time steps fails on this body.
  // Throws Cancelled.
  std::optional<double> deviationOf(const MovingBody& body, Job& job);
  // The same for each scene.
  std::optional<std::vector<double>> deviationsOf(const MovingBody& body, Job& job);

  // What the steps in time alone contribute to a deviation, in % of the diagonal: the difference between the
  // original with the step of the trial and with twice that step, over 3 for steps of second order and over 1
  // for those of first order (Richardson). 0 if there is no trial.
  double noiseFloor() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace limber
