#pragma once
#include <memory>
#include <string>
#include <vector>

#include <ringwatch/app/run/stepper.h>

namespace ringwatch {

/// Why a run cannot be on a GPU here: no CUDA in this build, or no GPU that works. "" when it can.
std::string whyNoDevice();
/// Steps on a GPU from `state` on: symplectic Euler without damping, alone or with a handler that runs there on top.
/// The state stays there between calls; each call brings it back. The body, with its loads and constraints, must not
/// change afterwards. options: of the handler, where there is one, kept by reference. devices: numbers
/// of the GPUs that share the steps; empty: all. Handlers take one. Throws InputError for what the GPU does not have,
/// or with need and free memory when it has too little of it.
std::unique_ptr<Stepper> makeDeviceStepper(const Body& body, const State& state, const HandlerOptions& options,
                                           const std::vector<int>& devices);

}  // namespace ringwatch
