#include <ringwatch/app/report/state_frame.h>

#include <ringwatch/base/units.h>

namespace ringwatch {

VtuFrame stateFrame(const Body& body, const NodeVectors& x, const CriticalStep* bracket, std::optional<double> step) {
  VtuFrame frame;
  frame.mesh = body.mesh();
  frame.mesh.X = x;
  if (bracket)
    frame.values = {{labelled("safe step (s)"), bracket->safe}, {labelled("optimistic step (s)"), bracket->optimistic}};
  if (step) frame.values[labelled("step (s)")] = *step;
  return frame;
}

std::vector<double> waveSpeedsOf(const Body& body) {
  std::vector<double> speeds;
  for (const auto& block : body.blocks()) speeds.push_back(block->material().waveSpeed());
  return speeds;
}

std::vector<int> blockOfElements(const Body& body) {
  std::vector<int> numbers;
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    numbers.insert(numbers.end(), static_cast<std::size_t>(body.blocks()[b]->elementCount()), static_cast<int>(b));
  return numbers;
}

}  // namespace ringwatch
