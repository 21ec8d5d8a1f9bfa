#include <ringwatch/extensions/tetrahedra/relaxing_handler.h>

#include <utility>

namespace ringwatch {

class RelaxingHandler::Relaxed final : public SecondOrderSystem {
 public:
  Relaxed(RelaxingHandler& owner, double h) : owner_(owner), h_(h) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    RelaxingHandler& o = owner_;
    o.explicitAcceleration(x, a);
    o.work().begin(x, a);
    std::string reason = o.relax(x, v, h_, a);
    if (fault.empty()) fault = std::move(reason);
    o.work().end(v, a);
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return true; }

  std::string fault;

 private:
  RelaxingHandler& owner_;
  double h_;
};

RelaxingHandler::RelaxingHandler(const HandlerInfo& info, Body& body, std::unique_ptr<Integrator> base,
                                 HandlerOptions options, std::string_view limited)
    : EnergyLimitedHandler(info, body, std::move(base), std::move(options)) {
  if (options_.own.text("variant") == limited) limitEnergy(options_.own.number("energy_limit"));
}

void RelaxingHandler::takeOwn(const NodeVectors&, double h, const ElementFlags& chosen) {
  takeRelaxed(h, chosen);
  countWork(h);
  detach(chosen);
}

StepStatus RelaxingHandler::ownStep(SecondOrderSystem&, State& state, double h) {
  Relaxed relaxed(*this, h);
  return baseStep(relaxed, state, h, relaxed.fault);
}

std::vector<HandlerFigure> RelaxingHandler::figures() const {
  std::vector<HandlerFigure> result = figuresOfPasses();
  result.push_back({"implicit_steps", static_cast<double>(imexSteps())});
  return result;
}

}  // namespace ringwatch
