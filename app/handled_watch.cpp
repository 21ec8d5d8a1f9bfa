#include <ringwatch/app/handled_watch.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/app/report.h>
#include <ringwatch/monitor/element_cause.h>

namespace ringwatch {

std::string HandledWatch::look(Handler& handler, const Body& body, std::int64_t step, double time, const NodeVectors& x,
                               std::vector<MonitorEvent>& events) {
  const auto least = handler.leastHandledDeterminant(x);
  if (least && !(least->value > 0)) {
    clear_ = 0;
    if (!inverted_) {
      const std::string cause = elementCause(body, x, least->element);
      added_.push_back(events.size());
      events.push_back({EventKind::inverted, step, time, least->value, least->element,
                        fmt::format("step {}, t = {:.6g} s: handled element inverted, det F = {:.3g}, {}: {}", step,
                                    time, least->value, elementText(body.mesh(), least->element), cause),
                        std::nullopt, cause});
      inverted_ = true;
    }
  } else if (inverted_) {
    if (clear_++ == 0) clearSince_ = step;
    if (clear_ >= MonitorOptions{}.clearLooks) {
      events[added_.back()].end = clearSince_;
      inverted_ = false;
    }
  }
  const std::string part = handler.uncertifiedPart(x);
  const bool begins = proven_ && !part.empty();
  proven_ = part.empty();
  return begins ? fmt::format("step {}, t = {:.6g} s: {}", step, time, part) : "";
}

bool HandledWatch::added(std::size_t event) const {
  return std::find(added_.begin(), added_.end(), event) != added_.end();
}

}  // namespace ringwatch
