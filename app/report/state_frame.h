#pragma once
#include <optional>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/formats/vtu_frame.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// A body at positions x (3×N, m) as a frame without fields of elements. bracket: nullptr for none; step: s, of the
/// run.
VtuFrame stateFrame(const Body& body, const NodeVectors& x, const CriticalStep* bracket, std::optional<double> step);

}  // namespace ringwatch
