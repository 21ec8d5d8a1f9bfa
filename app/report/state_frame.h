#pragma once
#include <optional>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/formats/vtu_frame.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// A body at positions x (3×N, m) as a frame without fields of elements. bracket: nullptr for none; step: s, of the
/// run.
VtuFrame stateFrame(const Body& body, const NodeVectors& x, const CriticalStep* bracket, std::optional<double> step);

/// Speeds of pressure waves of a body's blocks, m/s, and which block each element is of: what analyseFrame() asks for.
std::vector<double> waveSpeedsOf(const Body& body);
std::vector<int> blockOfElements(const Body& body);

}  // namespace ringwatch
