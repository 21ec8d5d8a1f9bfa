#include <ringwatch/handlers/fe_pbd/fe_pbd.h>

#include <algorithm>

#include <ringwatch/base/error.h>

namespace ringwatch {

class FePbd::Relaxed final : public SecondOrderSystem {
 public:
  explicit Relaxed(FePbd& owner) : owner_(owner) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    FePbd& o = owner_;
    o.explicitBody().internalForce(x, o.force_, o.workspace_);
    a = (o.body_.externalForce() - o.force_) * o.inverseMass_.asDiagonal();
    o.body_.constraints().clearConstrained(a);
    o.work().begin(x, a);
    if (!o.relaxed_->relax(x, v, a)) fault = "the handled elements' nodes are not at finite positions";
    o.work().end(v, a);
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return true; }

  std::string fault;

 private:
  FePbd& owner_;
};

FePbd::FePbd(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : Handler(description, body, std::move(base), std::move(options)),
      goal_(options_.own.text("variant") == variants[0] ? GoalShape::linear : GoalShape::rigid),
      passes_(std::max(1, options_.own.integer("passes"))) {}

void FePbd::take(const NodeVectors&, double h, const ElementFlags& chosen) {
  const auto elements = chosenElements(chosen);
  requireCorotationalTetrahedra(elements);
  relaxed_ = std::make_unique<RelaxedTetrahedra>(body_, elements, h, goal_, passes_);
  inverseMass_ = body_.lumpedMass().cwiseInverse();
  countWork(h);
  detach(chosen);
}

StepStatus FePbd::handledStep(SecondOrderSystem&, State& state, double h) {
  Relaxed relaxed(*this);
  return baseStep(relaxed, state, h, relaxed.fault);
}

std::vector<HandlerFigure> FePbd::figures() const {
  if (!relaxed_) return {};
  const auto [least, most] = std::minmax_element(relaxed_->alpha().begin(), relaxed_->alpha().end());
  return {{"handled_nodes", static_cast<double>(relaxed_->nodeCount())},
          {"largest_overlap", static_cast<double>(relaxed_->largestOverlap())},
          {"passes", static_cast<double>(relaxed_->passes())},
          {"least_alpha", *least},
          {"largest_alpha", *most}};
}

}  // namespace ringwatch
