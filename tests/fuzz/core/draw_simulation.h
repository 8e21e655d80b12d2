#pragma once

#include "fuzz_input.h"
#include "simulate/scenario.h"
#include "simulate/simulation_options.h"

namespace limber::fuzz {

// Options of a simulation: usual, extreme or impossible ones.
SimulationOptions drawSimulationOptions(FuzzInput& input);

// A scenario of 0.2 s for the mesh, with a ground and a ball at any place.
Scenario drawScenario(FuzzInput& input, const TriangleMesh& mesh, double unit);

}  // namespace limber::fuzz
