#pragma once
#include <span>
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Some elements, ascending, as a body of their own, on some nodes of the whole (all that they have). Blocks keep their
/// numbers. lumpedMass: kg, one for each of the nodes. It has the constraints of the whole, and no loads.
Body subBody(const Body& whole, std::span<const ElementRef> elements, std::span<const std::int32_t> nodes,
             Eigen::VectorXd lumpedMass, int threads);

}  // namespace ringwatch
