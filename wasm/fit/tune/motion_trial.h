#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/job.h"
#include "fit/tune/moving_body.h"

namespace limber {

// The motion trial before tuned parameters are returned: the original moves through one or two
// short scenes in our own implementation of a solver, and other bodies are compared with it.
//
// Scenes: `sway` for a closed body: the lower end of the longest side is pinned, and the rest starts
// perpendicular to that side with a velocity that grows with the square of the height, so that the swing
// peaks near 4 % of the diagonal for any stiffness. `hang` for an open one: it falls under gravity along -y
// from the user's pins, or from the upper end of its longest side. A closed body with user pins gets both.
//
// Springs, hinges and membranes move by the implicit steps of ImplicitMotion, and the shell with Morley's
// element by the XPBD of simulate/simulation.h, whose substeps are first-order accurate. With hinges an
// AreaBarrier keeps triangles from losing their area. There is no trial for an original of more than 20,000
// faces, or 10,000 with cross springs, because it would take more than about a minute.
//
// A scene lasts for one and a half periods of the motion itself: of the lowest frequency that carries a
// significant share of the energy of the swing, and for `hang` of that frequency combined with a pendulum's.
class MotionTrial {
 public:
  // Moves the original twice; the original and all objects that it refers to must outlive this object. Throws
  // Cancelled, and std::invalid_argument as SolverConstraints does.
  MotionTrial(const MovingBody& original, const SolverModel& model, Job& job);
  ~MotionTrial();
  MotionTrial(MotionTrial&&) noexcept;
  MotionTrial& operator=(MotionTrial&&) noexcept;

  // Why there is no trial, as a clause; empty if there is one.
  const std::string& refusal() const;
  // 'sway', 'hang', or 'sway and hang'.
  std::string scene() const;

  // Mean motion deviation of another mesh of the same body in % of the diagonal of the original, see
  // compare/motion_deviation.h: over points, steps and scenes. The user's pins are those of `body`, the pins
  // of `sway` are carried over. Empty if there is no trial, or if the time integration fails on this body.
  // Throws Cancelled.
  std::optional<double> deviationOf(const MovingBody& body, Job& job);
  // The same for each scene.
  std::optional<std::vector<double>> deviationsOf(const MovingBody& body, Job& job);

  // The time discretisation error in a deviation, in % of the diagonal: the difference between the original
  // with the step of the trial and with twice that step, divided by 3 for second-order steps and by 1 for
  // first-order ones (Richardson). 0 if there is no trial.
  double noiseFloor() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace limber
