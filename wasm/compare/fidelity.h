#pragma once

#include <vector>

#include "base/job.h"
#include "elastic/modes.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// How alike two bodies vibrate: Morley shell on both, thickness a fraction of the ORIGINAL's diagonal, exact
// solves, modes matched one to one by mass-weighted MAC after closest-point transfer onto the original.
// Errors in %.
struct Fidelity {
  double frequencyErrorMean = 0, frequencyErrorMax = 0;
  double frequencyErrorCalibrated = 0;                     // mean error after the best single factor on E
  double calibrationFactor = 1;                            // that factor
  double frequencyErrorThin = 0, frequencyErrorThick = 0;  // means at half and at twice the thickness
  double frequencyErrorHigh = 0;                           // mean over the next ten modes
  double macMean = 0, macMin = 0;  // subspace MACs over modes whose frequencies lie within 10 %
};

struct FidelityOptions {
  int modeCount = 10;
  double thickness = 0;  // in units of the mesh, > 0
  double young = 0, poisson = 0, density = 0, unit = 1;
};

// The lowest elastic modes of a body's shell over all of its parts, by ascending frequency.
struct ShellModes {
  std::vector<double> omega;  // rad/s
  std::vector<float> shapes;  // [(k * vertexCount + v) * 3 + c]
};

// The first 2 * options.modeCount modes, as compareFidelity solves for them. Throws Cancelled.
ShellModes shellModes(const TriangleMesh& mesh, const FidelityOptions& options, Job& job);

// frequencyErrorMean and frequencyErrorMax of compareFidelity.
struct FrequencyErrors {
  double mean = 0, max = 0;
};

// The first options.modeCount frequencies alone, where `modes` are the shellModes of the original with the
// same options: a sixth of the work of compareFidelity. Throws Cancelled, and std::invalid_argument where
// `modes` do not fit the original.
FrequencyErrors frequencyErrors(const TriangleMesh& original, const ShellModes& modes,
                                const TriangleMesh& other, const FidelityOptions& options, Job& job);

Fidelity compareFidelity(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job);

// Fidelity::calibrationFactor alone, for a fraction of the time: Young's modulus of `other`, times this,
// gives it the original's first frequencies.
double calibrationFactor(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job);

}  // namespace limber
