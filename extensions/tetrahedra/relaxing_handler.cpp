#include <ringwatch/extensions/tetrahedra/relaxing_handler.h>

#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/elements/registry.h>

namespace ringwatch {
namespace {

/// Throws InputError unless all elements of the body are tet4 of isotropic laws that turn with them: any of them may
/// become too stiff for the step along a run.
void requireCorotationalTetrahedra(std::string_view handler, const Body& body) {
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    const ElementBlock& block = *body.blocks()[b];
    if (block.elementCount() == 0) continue;
    if (body.mesh().blocks[b].type != elementTypeOf<Tet4>)
      throw InputError(joinText(handler, " handles tet4, and the mesh has ", block.element().name, "; take imex"));
    if (const LawInfo law = block.material().info(); !law.objective)
      throw InputError(
          joinText(handler, " turns with its elements, and the law \"", law.name, "\" does not; take imex"));
    else if (!law.isotropic)
      throw InputError(joinText(handler, " handles isotropic laws, and \"", law.name, "\" is none; take imex"));
  }
}

}  // namespace

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
  requireCorotationalTetrahedra(info.name, body);
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
