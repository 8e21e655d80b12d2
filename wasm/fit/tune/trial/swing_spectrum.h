#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "fit/tune/trial/implicit_system.h"

namespace limber {

// A frequency at which a body vibrates after a start with given velocities, and its share of the initial
// kinetic energy.
struct SwingLine {
  double omegaSquared = 0;  // 1/s2
  double share = 0;         // in [0, 1]
};

// The spectrum of small vibrations about rest that start with given velocities (m/s, of all vertices): nodes
// and weights of the Gauss quadrature of its spectral measure, by the Lanczos method on (K + sigma M)^-1 from
// the initial velocities (Golub and Meurant 2010, Matrices, Moments and Quadrature). Ascending; the lowest
// frequencies that carry energy are exact, the others each represent many. Rigid motions have frequencies
// near 0. Takes one factorisation. Empty if the velocities of free vertices are 0 or meet no resistance. Must
// be called within a WholePhase. Throws Cancelled.
std::vector<SwingLine> swingSpectrum(ImplicitSystem& system, std::span<const Vec3> velocities, Job& job);

// The expected size and frequency of a swing.
struct Swing {
  double omega = 0;    // rad/s: the lowest frequency with a significant share of the energy; 0 if none
  double seconds = 0;  // the largest displacement over the largest initial velocity
};
// Ignores rigid motions, and frequencies that are just as low compared to those that carry most energy.
Swing swingOf(std::span<const SwingLine> spectrum);

}  // namespace limber
