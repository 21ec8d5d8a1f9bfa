#include <ringwatch/monitor/event.h>

#include <ringwatch/base/error.h>
#include <ringwatch/elements/registry.h>

namespace ringwatch {
namespace {

/// What happened; "" where the element and its cause say it.
std::string whatHappened(const MonitorEvent& event) {
  switch (event.kind) {
    case EventKind::violated:
      return joinText("violated: h = ", event.h, " s is above the critical step, which is at most ",
                      event.h / event.value, " s", event.discreteShare > 0.5 ? "; springs or contact govern it" : "");
    case EventKind::energyBalance:
      return joinText("energy balance is off by ", 100 * event.value, " % of the largest energy so far");
    case EventKind::inverted:
      return event.cause ? "" : joinText("inverted, det F = ", event.value);
    case EventKind::nonFinite:
      return event.tangent ? "the tangent is not finite at these positions: no step helps"
                           : "positions or velocities are not finite";
    case EventKind::indefinite:
      return joinText("tangent indefinite, eigenvalue ", event.value, " rad2/s2: no step cures that");
    case EventKind::eroded:
      return joinText(event.value, event.value == 1 ? " element" : " elements", " eroded, the first");
    case EventKind::repeated:
      return joinText("repeated from here with h = ", event.value, " s, since h = ", event.h,
                      " s is not certified at step ", event.end.value_or(event.step));
  }
  return {};
}

}  // namespace

std::string elementText(const Mesh& mesh, ElementRef ref) { return elementText(mesh, ref, ref.element); }

std::string elementText(const Mesh& mesh, ElementRef ref, std::int32_t number) {
  const MeshBlock& block = mesh.blocks[ref.block];
  const std::size_t e = ref.element;
  std::string text = joinText(elementInfo(block.type).name, " element ", ref.block, ":", number);
  if (!block.ids.empty()) text += joinText(" (number ", block.id(e), ")");
  text += ", nodes";
  for (int a = 0; a < block.nodesPerElement(); ++a) text += joinText(" ", mesh.nodeId(block.element(e)[a]));
  return text;
}

std::string eventText(const MonitorEvent& event, const Mesh& mesh) {
  std::string text = joinText("step ", event.step, ", t = ", event.time, " s: ");
  const std::string what = whatHappened(event);
  text += what;
  if (event.element)
    text += joinText(what.empty()                ? ""
                     : event.discreteShare > 0.5 ? ", most at "
                                                 : ", ",
                     event.handled ? "handled " : "", elementText(mesh, *event.element));
  if (event.cause) text += ": " + causeText(*event.cause);
  return text;
}

bool EventTracker::isNew(EventKind kind) {
  Tracked& tracked = trackedOf(kind);
  tracked.clear = 0;
  return !tracked.event;
}

const MonitorEvent& EventTracker::begin(const MonitorEvent& event) {
  trackedOf(event.kind).event = events_.size();
  return events_.emplace_back(event);
}

void EventTracker::absent(EventKind kind, std::int64_t step) {
  Tracked& tracked = trackedOf(kind);
  if (!tracked.event) return;
  if (tracked.clear++ == 0) tracked.clearSince = step;
  if (tracked.clear < clearObservations_) return;
  events_[*tracked.event].end = tracked.clearSince;
  tracked.event.reset();
}

}  // namespace ringwatch
