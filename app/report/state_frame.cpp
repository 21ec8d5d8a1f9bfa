#include <ringwatch/app/report/state_frame.h>

namespace ringwatch {

VtuFrame stateFrame(const Body& body, const NodeVectors& x, const CriticalStep* bracket, std::optional<double> step) {
  VtuFrame frame;
  frame.mesh = body.mesh();
  frame.mesh.X = x;
  if (bracket) frame.values = {{"safe step (s)", bracket->safe}, {"optimistic step (s)", bracket->optimistic}};
  if (step) frame.values["step (s)"] = *step;
  return frame;
}

}  // namespace ringwatch
