#include <ringwatch/handlers/handler.h>

#include <cmath>

#include <ringwatch/base/error.h>

namespace ringwatch {

bool takesHandler(const IntegratorInfo& info) {
  return info.imaginaryLimit == 2 && info.forceEvaluations == 1 && info.symplectic && !info.adaptive &&
         !info.partitioned;
}

Handler::Handler(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : body_(body), base_(std::move(base)), options_(std::move(options)), chosen_(noElements(body.mesh())) {
  if (!takesHandler(base_->info()))
    throw InputError(joinText("handlers work on symplectic-euler and verlet, not on \"", base_->info().name, "\""));
  if (options_.selection != "certified" && options_.selection != "reduced-1-ring" &&
      options_.selection != "single-element")
    throw InputError(
        joinText("selection \"", options_.selection, "\": must be one of certified, reduced-1-ring, single-element"));
  if (!(options_.margin >= 0 && options_.margin < 1))
    throw InputError(joinText("margin ", options_.margin, ": must be >= 0 and < 1"));
}

void Handler::prepare(const NodeVectors& x, double h) {
  if (!(h > 0) || !std::isfinite(h)) throw InputError(joinText("step ", h, " s: must be > 0 and finite"));
  const double lambda = allowedLambda(h);
  const bool proven = options_.selection != "reduced-1-ring";
  ElementFlags chosen;
  if (options_.selection == "certified") {
    certificate_ = selectCertified(body_, x, lambda, chosen_);
    chosen = certificate_->chosen;
  } else {
    certificate_.reset();
    chosen = proven ? selectBySingleElement(body_, x, lambda) : selectByReducedRing(body_, x, lambda);
    for (std::size_t b = 0; b < chosen.size(); ++b)
      for (std::size_t e = 0; e < chosen[b].size(); ++e) chosen[b][e] = chosen[b][e] || chosen_[b][e];
  }
  h_ = h;
  certified_ = proven;
  chosen_ = std::move(chosen);
  elements_ = chosenElements(chosen_);
  reset();
  if (!elements_.empty()) take(x, h, chosen_);
}

double Handler::allowedLambda(double h) const {
  const double omega = (1 - options_.margin) * base_->info().imaginaryLimit / h;
  return omega * omega;
}

StepStatus Handler::step(SecondOrderSystem& system, State& state, double h) {
  if (elements_.empty()) return base_->step(system, state, h);
  if (h != h_) throw InputError(joinText("step ", h, " s: the handler was prepared for ", h_, " s"));
  return handledStep(system, state, h);
}

void Handler::requireTurningTetrahedra(const std::vector<ElementRef>& elements) const {
  for (const ElementRef e : elements) {
    const ElementBlock& block = *body_.blocks()[static_cast<std::size_t>(e.block)];
    const std::string_view name = handlerInfo().name;
    if (block.element().name != "tet4")
      throw InputError(joinText(name, " handles tet4, and element ", e.block, ":", e.element, " is a ",
                                block.element().name, "; take imex"));
    if (block.material().lawName() == "linear")
      throw InputError(joinText(name, " turns with its elements, and the law \"linear\" does not; take imex"));
  }
}

void Handler::splitOff(const ElementFlags& chosen) {
  const ElementFlags left = complement(chosen);
  explicitPart_.emplace(body_, left);
  numbers_ = elementNumbers(left);
}

ElementRef Handler::wholeElement(ElementRef part) const {
  if (!explicitPart_) return part;
  return {part.block, numbers_[static_cast<std::size_t>(part.block)][static_cast<std::size_t>(part.element)]};
}

}  // namespace ringwatch
