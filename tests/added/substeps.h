#pragma once
#include <ringwatch/handlers/handler.h>

namespace ringwatch::test {

/// A handler added from outside, with an option of its own: where elements are handled, the whole body takes substeps.
class Substeps final : public Handler {
 public:
  static constexpr std::array table{OptionInfo{.name = "substeps",
                                               .type = OptionType::integer,
                                               .range = {1, 100, true, true},
                                               .fallback = "4",
                                               .help = "that make a step"}};
  static constexpr std::array selections{Selection::certified};
  static constexpr HandlerInfo description{.name = "substeps",
                                           .help = "smaller steps of the whole body",
                                           .alias = "subcycles",
                                           .options = table,
                                           .selections = selections};
  Substeps(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
      : Handler(description, body, std::move(base), std::move(options)), count_(options_.own.integer("substeps")) {}
  std::vector<HandlerFigure> figures() const override { return {{"substeps", static_cast<double>(count_)}}; }

 protected:
  void take(const NodeVectors&, double, const ElementFlags& chosen) override { detach(chosen); }
  StepStatus handledStep(SecondOrderSystem& system, State& state, double h) override {
    StepStatus status;
    for (int i = 0; i < count_ && status.done; ++i) status = base_->step(system, state, h / count_);
    return status;
  }

 private:
  int count_;
};

}  // namespace ringwatch::test
