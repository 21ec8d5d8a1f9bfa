#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/base/name_table.h>
#include <ringwatch/monitor/element_cause.h>

namespace ringwatch {

/// What can happen. Every event has a beginning, which is reported once, and an end.
/// indefinite: the tangent has a negative eigenvalue, which only compressed elements can give it; proven by a direction
/// of negative stiffness (Theorem 11, docs/theory/rings_and_rayleigh.md). Where some element is
/// compressed by more than 1e-3 of λ+2μ, the monitor searches for a direction of negative stiffness in the whole body:
/// 48 tangent products at the first evaluation; 12, from the direction found last, when compression has grown by half
/// since the last search; and else after 80, 160, … 2560 evaluations. With a budget (MonitorOptions) searches are of 6,
/// when compression has doubled and the budget affords them. With a compression above 0.05 it also evaluates
/// 32 reduced 1-rings at each of these and after 10 evaluations, with a budget as many as that affords. A mode
/// that is far softer than the elements, as of a slender bar that buckles, can be missed; what is told is proven.
/// eroded: elements have left the body. repeated: a run goes back to the state before this step, since a later one is
/// not certified. These are told by the run itself, not by a monitor.
enum class EventKind { violated, energyBalance, inverted, nonFinite, indefinite, eroded, repeated };
inline constexpr auto eventNames = nameTable<EventKind>({
    {EventKind::violated, "violated"},
    {EventKind::energyBalance, "energy-balance"},
    {EventKind::inverted, "inverted"},
    {EventKind::nonFinite, "non-finite"},
    {EventKind::indefinite, "indefinite"},
    {EventKind::eroded, "eroded"},
    {EventKind::repeated, "repeated"},
});
constexpr std::string_view eventName(EventKind kind) { return eventNames.nameOf(kind); }

/// Something that happened, as data.
struct MonitorEvent {
  EventKind kind = EventKind::violated;
  std::int64_t step = 0;
  double time = 0;  // s
  /// violated: h over the optimistic step; energyBalance: the balance error over the largest energy so far; inverted:
  /// det F; indefinite: an eigenvalue, rad²/s²; eroded: how many elements; repeated: the
  /// step (s) from there on; nonFinite: none.
  double value = 0;
  double h = 0;                            // s, violated: the step that was asked about; repeated: that of before
  bool tangent = false;                    // nonFinite: of the tangent, at positions that are finite
  double discreteShare = 0;                // violated: CriticalStep::discreteShare
  bool handled = false;                    // a handler takes care of the element
  std::optional<ElementRef> element = {};  // where, when it is an element's doing
  std::optional<ElementCause> cause = {};  // why that element is in the way
  std::optional<std::int64_t> end = {};    // first step without it; empty while it goes on
};

/// "tet4 element 0:5 (number 6), nodes 1 2 3 4": block and element from 0, the rest as numbered in the file, where
/// there is one.
std::string elementText(const Mesh& mesh, ElementRef element);
/// The same of a mesh that is a part of another one, in which the element has that number in its block.
std::string elementText(const Mesh& part, ElementRef element, std::int32_t number);

/// An event of the mesh in one line: "step 12, t = 0.06 s: violated: h = …, tet4 element 0:5 …: stretched 1.6".
std::string eventText(const MonitorEvent& event, const Mesh& mesh);

/// Begins and ends events. Near a limit one may come and go from step to step: it is one event until it has stayed away
/// for a number of observations in a row, and ends with the first of them.
class EventTracker {
 public:
  explicit EventTracker(int clearObservations) : clearObservations_(clearObservations) {}

  /// The event goes on; true when it begins here, and then `begin` is to be called with it.
  bool isNew(EventKind kind);
  const MonitorEvent& begin(const MonitorEvent& event);
  /// An observation without the event, before step number `step`.
  void absent(EventKind kind, std::int64_t step);
  /// All so far, in the order of their beginnings.
  const std::vector<MonitorEvent>& events() const { return events_; }

  template <class Archive>
  void archive(Archive& a) {
    a(events_);
    for (Tracked& tracked : tracked_) a(tracked);
  }

 private:
  struct Tracked {
    std::optional<std::size_t> event;  // of `events_`, that has not ended
    int clear = 0;                     // observations in a row without it
    std::int64_t clearSince = 0;       // step of the first of them
  };
  Tracked& trackedOf(EventKind kind) { return tracked_[static_cast<std::size_t>(kind)]; }

  int clearObservations_;
  std::vector<MonitorEvent> events_;
  Tracked tracked_[eventNames.size()];
};

}  // namespace ringwatch
