#include <ringwatch/app/run/handled_watch.h>

#include <ringwatch/body/domain.h>

namespace ringwatch {

std::optional<MonitorEvent> HandledWatch::observe(Handler& handler, const Body& body, std::int64_t step, double time,
                                                  const NodeVectors& x) {
  uncertifiedPart_ = handler.uncertifiedPart(x);
  const auto least = handler.leastHandledDeterminant(x);
  if (!least || least->value > 0 || body.blocks()[least->element.block]->material().info().allowsInversion) {
    tracker_.absent(EventKind::inverted, step);
    return std::nullopt;
  }
  if (!tracker_.isNew(EventKind::inverted)) return std::nullopt;
  return tracker_.begin({.kind = EventKind::inverted,
                         .step = step,
                         .time = time,
                         .value = least->value,
                         .handled = true,
                         .element = least->element,
                         .cause = elementCause(body, body.domain().withGhosts(x), least->element)});
}

std::optional<MonitorEvent> HandledWatch::observeEnergies(const Energies& energies, std::int64_t step, double time,
                                                          double tolerance) {
  const auto share = energies_.observe(energies, step, tolerance);
  if (!share) {
    tracker_.absent(EventKind::energyBalance, step);
    return std::nullopt;
  }
  if (!tracker_.isNew(EventKind::energyBalance)) return std::nullopt;
  return tracker_.begin(
      {.kind = EventKind::energyBalance, .step = step, .time = time, .value = *share, .handled = true});
}

}  // namespace ringwatch
