#pragma once

#include "base/job.h"
#include "elastic/mode_conversions.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// How similarly two bodies vibrate. Both are solved exactly as Morley shells of the same absolute thickness.
// Modes are matched one to one by mass-weighted MAC, after the shapes of the other body have been transferred
// to the closest points of the original. Errors in %.
struct Fidelity {
  double frequencyErrorMean = 0, frequencyErrorMax = 0;  // over the first modeCount modes
  // Mean error with the single factor on E that minimises the sum of the squared errors. If the mean error is
  // no smaller with it, the factor is 1.
  double frequencyErrorCalibrated = 0;
  double calibrationFactor = 1;                            // that factor
  double frequencyErrorThin = 0, frequencyErrorThick = 0;  // means at half and at twice the thickness
  double frequencyErrorHigh = 0;   // mean over the next modeCount modes; NaN if the original has none
  double macMean = 0, macMin = 0;  // subspace MACs, over modes whose frequencies lie within 10 %
};

struct FidelityOptions {
  int modeCount = 10;  // compared modes, >= 1
  ElasticMaterial material;
};

// The first 2 * options.modeCount modes of a body's shell over all of its parts, as compareFidelity solves
// for them: see lowestModes. Throws as findModes.
ModeBasis shellModes(const TriangleMesh& mesh, const FidelityOptions& options, Job& job);

// The fields frequencyErrorMean and frequencyErrorMax of Fidelity.
struct FrequencyErrors {
  double mean = 0, max = 0;
};

// Only the errors of the first options.modeCount frequencies, at a sixth of the cost of compareFidelity.
// `modes`: the shellModes of the original with the same options. Throws as findModes, and
// std::invalid_argument if `modes` do not fit the original.
FrequencyErrors frequencyErrors(const TriangleMesh& original, const ModeBasis& modes,
                                const TriangleMesh& other, const FidelityOptions& options, Job& job);

// Throws as findModes.
Fidelity compareFidelity(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job);

// Only Fidelity::calibrationFactor, in a fraction of the time: with this factor on its Young's modulus,
// `other` matches the first frequencies of the original. Throws as findModes.
double calibrationFactor(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job);

}  // namespace limber
