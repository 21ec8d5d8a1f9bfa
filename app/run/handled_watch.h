#pragma once
#include <string>
#include <vector>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/monitor/energy_check.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// Watches what a monitor of the explicit elements does not see: handled elements that invert, and handled parts that
/// are no longer proven stable.
class HandledWatch {
 public:
  /// Observes the state before a step. Returns the event that begins with it, if one does.
  std::optional<MonitorEvent> observe(Handler& handler, const Body& body, std::int64_t step, double time,
                                      const NodeVectors& x);
  /// The same of the energies of the state, over all choices of the handler. tolerance: of the balance error, as a
  /// share of the largest energy so far.
  std::optional<MonitorEvent> observeEnergies(const Energies& energies, std::int64_t step, double time,
                                              double tolerance);
  /// All events so far.
  const std::vector<MonitorEvent>& events() const { return tracker_.events(); }
  /// The part that the handler did not know to be stable at the last observation, "" for none.
  const std::string& uncertifiedPart() const { return uncertifiedPart_; }

 private:
  EventTracker tracker_{MonitorOptions{}.clearObservations};
  EnergyCheck energies_{0};
  std::string uncertifiedPart_;
};

}  // namespace ringwatch
