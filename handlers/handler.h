#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/base/options.h>
#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handled_work.h>
#include <ringwatch/handlers/least_determinant.h>
#include <ringwatch/handlers/selection/incremental_selection.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Room for an explicit part that stiffens along the run, where neither an option nor the law asks for another.
inline constexpr double defaultMargin = 0.1;

/// What all handlers share, and the options of the one that is made.
struct HandlerOptions {
  Selection selection = Selection::certified;
  /// Elements are chosen as for a step of h/(1 - margin), >= 0 and < 1: room for an explicit part that stiffens along
  /// the run. None: marginFor() the handler and the body.
  std::optional<double> margin = {};
  Options own = {};  ///< by name, as HandlerInfo::options declares them; those that are not given have their defaults
  RayleighDamping damping = {};  ///< of the systems that the handler is to step
};

/// The option of a handler that has more than one way; auto is the first.
constexpr OptionInfo variantOption(std::span<const std::string_view> variants, std::string_view help) {
  return {.name = "variant",
          .type = OptionType::text,
          .choices = variants,
          .automatic = true,
          .fallback = "auto",
          .help = help};
}

/// What a handler declares of itself: scenes, command line, help texts, studies and tests take it from here.
struct HandlerInfo {
  std::string_view name;
  std::string_view help;
  std::string_view alias = {};  ///< an older name, accepted wherever the name is; "" for none
  std::span<const OptionInfo> options = {};
  std::span<const Selection> selections = everySelection;        ///< that it works with
  bool addsMass = false;                                         ///< to the body, for good
  bool takesMassDamping = false, takesStiffnessDamping = false;  ///< HandlerOptions::damping
  bool relaxes = false;  ///< positions, in passes each of which carries stress over one element
  /// Where its steps can be taken on a GPU, which has them of the library's own handlers alone: gives options that are
  /// not given the defaults they have there, and says why the others cannot go there, "" when they can. nullptr: they
  /// cannot be taken there.
  std::string (*forGpu)(Options& own) = nullptr;
  /// The margin that a law needs where none is given; nullptr: defaultMargin for all.
  double (*marginOfLaw)(std::string_view law) = nullptr;

  static constexpr std::array everySelection{Selection::certified, Selection::fierzRing, Selection::elementFrequency};
  bool takes(Selection selection) const;
};

/// The highest frequency squared, rad²/s², for which a scheme with a limit of h·omega is stable at a step of h/(1 -
/// margin): ((1 - margin) limit/h)², and with Rayleigh damping (1 - margin)² (1 - alpha h/2)/(h²/4 + beta h/2) (Theorem
/// 47, docs/theory/discrete_forces.md). Throws InputError where mass damping alone needs a smaller step.
double largestEigenvalueFor(double h, double margin, double limit, const RayleighDamping& damping);

/// The margin where none is given: the largest of those that the body's laws need.
double marginFor(const HandlerInfo& info, const Body& body);

/// A number that a handler reports, for summaries.
struct HandlerFigure {
  std::string name;  // with its unit, e.g. "added_mass_kg"
  double value;
  bool ofHost = false;  // counts work that a GPU, where it takes the steps, does in its own way
};

/// Keeps a step that is too large for some elements: an explicit integrator that also owns the set of elements which it
/// treats apart, chosen for a step at a state. Where it chooses none it is the base integrator, bit for bit.
class Handler : public Integrator {
 public:
  /// info: of the handler, must outlive it. base: an explicit scheme with a stability limit of 2 and one force a step
  /// (symplectic-euler, verlet); others throw InputError, and so do options that the handler does not declare or that
  /// are out of their range. The body must outlive the handler; its constraints and elements must not change between
  /// prepare and the steps.
  Handler(const HandlerInfo& info, Body& body, std::unique_ptr<Integrator> base, HandlerOptions options);

  const HandlerInfo& handlerInfo() const { return info_; }
  const IntegratorInfo& info() const override { return base_->info(); }

  /// Chooses the elements to handle for steps of h (s, > 0) at positions x (3×N, m), those chosen before among them.
  /// Throws InputError for options or a body that it cannot work with. Changes what steps compute: empty State::a after
  /// it.
  void prepare(const NodeVectors& x, double h);
  /// Chooses for a body whose mesh was cut: the choice of the handler of the body before, carried over to what the cut
  /// left as it was. With Selection::fierzRing only the changed elements are examined; `certified` chooses again among
  /// those and their neighbours and keeps the proof of all others (IncrementalSelection).
  void prepare(const NodeVectors& x, double h, const CutMesh& cut, const Handler& before);
  /// Handles what another handler of this body has chosen, for the steps that it was prepared for, from positions x
  /// (3×N, m) on: without a choice of its own.
  void prepareAs(const Handler& other, const NodeVectors& x);
  /// Handles, on a part of the body of another handler (body/domain.h), what that one has chosen for the whole.
  /// explicitPart: the part of its explicitBody() on this body's nodes, nullptr where no element leaves it. On the
  /// first process both must outlive the handler, which takes what figures of the whole it needs from there.
  /// Collective.
  void prepareAsPart(const Handler& whole, const Body* explicitPart);
  /// Why steps of parts of a body cannot be taken with the elements that are chosen, "" where they can.
  virtual std::string whyNotInParts() const { return {}; }
  /// Takes a step of the size that it was prepared for; another throws InputError.
  StepStatus step(SecondOrderSystem& system, State& state, double h) override;
  StepStatus advance(SecondOrderSystem& system, State& state, double h) override;
  bool beginsWithAcceleration() const override;
  void reset() override {
    base_->reset();
    baseAcceleration_.resize(3, 0);
  }

  /// The handled elements, as flags and ascending.
  const ElementFlags& chosen() const { return chosen_; }
  const std::vector<ElementRef>& elements() const { return elements_; }
  /// Their number, in the whole body.
  std::int64_t handledElements() const { return handled_; }
  /// Steps that its own are divided into, where explicitBody() does not show it: on a part of a body.
  virtual int partsOfStep() const { return 1; }
  /// The elements that the base scheme alone must be stable for, on the whole lumped mass: what a monitor watches. The
  /// body itself where no element leaves the explicit part.
  const Body& explicitBody() const { return ofPart_ ? *ofPart_ : explicitPart_ ? *explicitPart_ : body_; }
  /// The element of the body that has a number in explicitBody().
  ElementRef toParentElement(ElementRef part) const;
  /// Whether the explicit part is proven stable for the tangent at the positions it was prepared for; by the theorem
  /// of its selection or handler (Theorems 31 to 40, docs/theory/handlers.md).
  virtual bool certified() const { return certified_; }
  virtual std::vector<HandlerFigure> figures() const { return {}; }
  /// What the time integration of the handled elements has taken from their energy since the handler was made, J
  /// (HandledWork). Less than nothing: it has added to it.
  /// Collective.
  virtual double dissipated() const;
  /// Whether steps of which every element is handled are proven stable for the tangent at each state, as they are where
  /// the explicit part is certified and nothing else is assumed.
  virtual bool provesHandledPart() const { return false; }
  /// Least det F over the handled elements and their quadrature points at positions x (3×N, m), with its element; for
  /// those that are not in explicitBody(), where a monitor observes. Nothing where there are none.
  std::optional<Body::LeastDeterminant> leastHandledDeterminant(const NodeVectors& x) const;
  /// Which handled part is no longer proven stable for the tangent at positions x (3×N, m), and "" when none is known
  /// to be: where a proof for explicitBody() is not all that it takes.
  virtual std::string uncertifiedPart(const NodeVectors&) { return {}; }
  /// Whether it would choose again where the explicit part is certified: at less cost.
  virtual bool asksForChoice() const { return false; }
  /// What it has changed of its own since this was asked last, a sentence; "" for nothing.
  virtual std::string news() { return {}; }
  /// What the last choice took: elements evaluated again, and evaluations of a single element or ring.
  struct SelectionCost {
    std::int64_t elements = 0, evaluations = 0;
  };
  const SelectionCost& selectionCost() const { return selectionCost_; }

 protected:
  /// Called after a choice that is not empty.
  virtual void take(const NodeVectors& x, double h, const ElementFlags& chosen) = 0;
  virtual StepStatus handledStep(SecondOrderSystem& system, State& state, double h) = 0;
  /// Takes over what the handler of the body before a cut knows, but for its choice: before the first choice.
  virtual void inherit(const Handler&) {}
  /// Whether a step is one of the base scheme on the system itself.
  virtual bool stepsAsBase() const { return handled_ == 0; }
  /// Whether handledStep begins with the acceleration of the state by the system, and takes State::a for it.
  virtual bool handledBeginsWithAcceleration() const { return false; }
  /// A step of the base scheme in which the system may find a fault: then the state is as before it, and the status
  /// says what it is. fault: filled in by the system, empty else.
  StepStatus baseStep(SecondOrderSystem& system, State& state, double h, const std::string& fault);
  /// The state before the last baseStep(), which is as if it had not been.
  void takeBack(State& state);
  std::span<const std::int32_t> nodesOf(ElementRef e) const { return body_.blocks()[e.block]->nodesOf(e.element); }
  /// Which elements, those of `keep` among them: those that a limit of allowedLambda(h) asks for.
  virtual ElementFlags choose(const NodeVectors& x, double h, const ElementFlags& keep) {
    return chooseFor(x, allowedLambda(h), keep);
  }
  /// The elements that a limit of lambda, rad²/s², asks for, as the selection says.
  ElementFlags chooseFor(const NodeVectors& x, double lambda, const ElementFlags& keep);
  /// Least det F over the handled elements at positions x (3×N, m), with its element; nothing where there are none.
  std::optional<Body::LeastDeterminant> leastDeterminantOfChosen(const NodeVectors& x) const;
  /// Leaves the chosen elements out of explicitBody(); with mass (kg, N numbers > 0), that is its lumped mass.
  void detach(const ElementFlags& chosen, const Eigen::VectorXd& mass = {});
  /// The acceleration at x (3×N, m) by loads and the elements of explicitBody(), m/s², of the lumped mass of the body.
  /// Collective.
  void explicitAcceleration(const NodeVectors& x, NodeVectors& a);
  /// explicitBody() is the body itself again.
  void attachAll() { explicitPart_.reset(); }
  /// Some elements of the body with another lumped mass, kg, N numbers > 0; without loads.
  Body partWithMass(const ElementFlags& elements, const Eigen::VectorXd& mass) const;
  /// The highest frequency squared that is left to the explicit part, rad²/s²: largestEigenvalueFor() its margin and
  /// scheme.
  double allowedLambda(double h) const {
    return largestEigenvalueFor(h, margin(), base_->info().imaginaryLimit, options_.damping);
  }
  double margin() const { return *options_.margin; }
  /// The bound behind a certified choice; none with other selections.
  const CertifiedSelection* certificate() const;
  /// Counts the work of the chosen elements from here on, in steps of h. The handler tells of each step (HandledWork).
  void countWork(double h);
  /// Keeps what was dissipated with the choice before; the work is counted by the handler itself.
  void closeWork();
  HandledWork& work() { return works_.front(); }
  /// That of all elements together or, on a part of a body, of each cluster.
  std::span<HandledWork> works() { return works_; }
  /// Notes the cost of a choice that is not one of chooseFor().
  void noteSelectionCost(SelectionCost cost) { selectionCost_ = cost; }

  Body& body_;
  std::unique_ptr<Integrator> base_;
  HandlerOptions options_;  // with all defaults filled in
  NodeVectors baseAcceleration_ =
      NodeVectors(3, 0);  // State::a of the base scheme on the system that baseStep gives it

 private:
  /// candidates: the elements to evaluate; empty for all.
  void prepareFor(const NodeVectors& x, double h, const ElementFlags& candidates);
  void handle(ElementFlags chosen, const NodeVectors& x);

  const HandlerInfo& info_;
  double h_ = 0;
  bool certified_ = false;
  ElementFlags chosen_, candidates_;
  State before_;  // the step that is being taken
  std::vector<ElementRef> elements_;
  std::optional<LeastDeterminant> determinants_;  // of elements_
  IncrementalSelection selection_;
  SelectionCost selectionCost_;
  std::vector<HandledWork> works_;
  double dissipatedBefore_ = 0;  // J, with the choices before
  std::optional<Body> explicitPart_;
  const Body* ofPart_ = nullptr;  // explicitBody() of prepareAsPart()
  std::int64_t handled_ = 0;
  bool ghostsAreThere_ = false;  // at the positions that an acceleration is asked for next
  Eigen::VectorXd inverseMass_;  // of the body
  NodeVectors explicitForce_;
  Body::Workspace explicitWorkspace_;
  std::vector<std::vector<std::int32_t>> numbers_;  // [block][element of the part]: number in the body
};

/// A handler that can be made by name.
struct HandlerEntry {
  const HandlerInfo* info;
  std::unique_ptr<Handler> (*make)(Body& body, std::unique_ptr<Integrator> base, const HandlerOptions& options);
};
/// The entry of a class with a `description` that is made as Handler is, without the info.
template <class H>
constexpr HandlerEntry handlerEntry() {
  return {&H::description,
          [](Body& body, std::unique_ptr<Integrator> base, const HandlerOptions& options) -> std::unique_ptr<Handler> {
            return std::make_unique<H>(body, std::move(base), options);
          }};
}
/// Every handler, one line each in registry.cpp, and those that were registered.
std::span<const HandlerEntry> allHandlers();
/// Adds one; call it when the program starts, before any is asked for. Throws InputError when the name is taken.
void registerHandler(const HandlerEntry& entry);
/// The handler of a name or alias; nullptr when there is none.
const HandlerInfo* findHandler(std::string_view name);
/// The options as far as the handler takes them: others are left out, a selection that it does not take is its first.
HandlerOptions optionsFor(const HandlerInfo& info, const HandlerOptions& options);
/// Makes a handler by name or alias. Throws InputError that lists the names when there is none.
std::unique_ptr<Handler> makeHandler(std::string_view name, Body& body, std::unique_ptr<Integrator> base,
                                     const HandlerOptions& options = {});
/// Whether handlers work on top of an integrator.
bool takesHandler(const IntegratorInfo& info);

}  // namespace ringwatch
