#pragma once
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// Looks along a run at what a monitor of the explicit elements does not see: handled elements that invert, and handled
/// parts that are no longer proven stable.
class HandledWatch {
 public:
  /// Looks at the state before a step. Adds an event to `events`, which may only grow from call to call, when a handled
  /// element is found inverted, and ends it as a monitor ends its own. Returns a line when a part has ceased to be
  /// proven, "" else.
  std::string look(Handler& handler, const Body& body, std::int64_t step, double time, const NodeVectors& x,
                   std::vector<MonitorEvent>& events);
  /// Whether all that the handler knows of was proven at the last look.
  bool proven() const { return proven_; }
  /// Whether an event is one of these.
  bool added(std::size_t event) const;

 private:
  std::vector<std::size_t> added_;
  bool inverted_ = false, proven_ = true;  // the last of added_ goes on
  int clear_ = 0;                          // looks in a row without it
  std::int64_t clearSince_ = 0;            // step of the first of them
};

}  // namespace ringwatch
