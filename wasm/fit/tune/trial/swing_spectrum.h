#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "fit/tune/trial/implicit_system.h"

namespace limber {

// A frequency at which a body vibrates after a start with given velocities, and the share of the kinetic
// energy of the start that it carries.
struct SwingLine {
  double omegaSquared = 0;  // 1/s2
  double share = 0;         // in [0, 1]
};

// The spectrum of small vibrations about rest that start with given velocities (m/s, of all vertices): nodes
// and weights of the Gauss quadrature of its spectral measure, by Lanczos' method on (K + sigma M)^-1 from
// the start (Golub and Meurant 2010, Matrices, Moments and Quadrature). Ascending; the lowest frequencies
// that carry energy are exact, the others stand for many. Rigid motions have frequencies near 0. Needs one
// factorisation. Empty where the velocities of free vertices are 0, or meet no resistance. To be called
// within a WholePhase. Throws Cancelled.
std::vector<SwingLine> swingSpectrum(ImplicitSystem& system, std::span<const Vec3> velocities, Job& job);

// What to expect of a swing.
struct Swing {
  double omega = 0;    // rad/s: the lowest frequency that carries a noticeable share of the energy; 0 if none
  double seconds = 0;  // the largest displacement over the largest velocity of the start
};
// Rigid motions, and frequencies as low beside those that carry most energy, are left out.
Swing swingOf(std::span<const SwingLine> spectrum);

}  // namespace limber
