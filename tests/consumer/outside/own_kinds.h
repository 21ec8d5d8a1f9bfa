// What an outside project adds to ringwatch.
#pragma once
#include <cmath>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/metrics.h>

namespace outside {

class Euler final : public ringwatch::Integrator {
 public:
  static constexpr ringwatch::IntegratorInfo description{.name = "own-euler",
                                                         .help = "symplectic Euler again",
                                                         .order = 1,
                                                         .forceEvaluations = 1,
                                                         .imaginaryLimit = 2,
                                                         .symplectic = true};
  const ringwatch::IntegratorInfo& info() const override { return description; }
  ringwatch::StepStatus step(ringwatch::SecondOrderSystem& system, ringwatch::State& state, double h) override {
    system.acceleration(state.time, state.x, state.v, a_);
    state.v += h * a_;
    state.x += h * state.v;
    state.time += h;
    return {};
  }

 private:
  ringwatch::NodeVectors a_;
};

/// A wave that crosses the shortest edge from an element's first node.
inline ringwatch::MetricValues byEdge(const ringwatch::Body& body, const ringwatch::NodeVectors& x,
                                      const ringwatch::MetricProgress&) {
  ringwatch::MetricValues values;
  for (const auto& block : body.blocks()) {
    auto& own = values.emplace_back();
    for (std::int32_t e = 0; e < block->elementCount(); ++e) {
      const auto nodes = block->nodesOf(e);
      double shortest = INFINITY;
      for (std::size_t a = 1; a < nodes.size(); ++a)
        shortest = std::min(shortest, (x.col(nodes[a]) - x.col(nodes[0])).norm());
      own.push_back(std::pow(2 * block->material().waveSpeed() / shortest, 2));
    }
  }
  return values;
}
inline constexpr ringwatch::MetricEntry shortestEdge{
    {"shortest-edge", "a pressure wave along the shortest edge", ringwatch::Direction::estimate}, byEdge};

/// Where elements are handled, the whole body takes smaller steps.
class Substeps final : public ringwatch::Handler {
 public:
  static constexpr std::array table{ringwatch::OptionInfo{.name = "substeps",
                                                          .type = ringwatch::OptionType::integer,
                                                          .range = {1, 100, true, true},
                                                          .fallback = "4",
                                                          .help = "that make a step"}};
  static constexpr ringwatch::HandlerInfo description{
      .name = "substeps", .help = "smaller steps of the whole body", .options = table};
  Substeps(ringwatch::Body& body, std::unique_ptr<ringwatch::Integrator> base, ringwatch::HandlerOptions options)
      : Handler(description, body, std::move(base), std::move(options)), count_(options_.own.integer("substeps")) {}

 protected:
  void take(const ringwatch::NodeVectors&, double, const ringwatch::ElementFlags&) override {}
  ringwatch::StepStatus handledStep(ringwatch::SecondOrderSystem& system, ringwatch::State& state, double h) override {
    ringwatch::StepStatus status;
    for (int i = 0; i < count_ && status.done; ++i) status = base_->step(system, state, h / count_);
    return status;
  }

 private:
  int count_;
};

}  // namespace outside
