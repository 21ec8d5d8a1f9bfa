#include <ringwatch/handlers/imex/imex.h>

#include <algorithm>

#include <ringwatch/base/error.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/handlers/angular_momentum.h>
#include <ringwatch/handlers/imex/solve_clusters.h>
#include <ringwatch/materials/linear_elastic.h>

namespace ringwatch {

std::string imexForGpu(Options& own) {
  const OptionValue* solver = own.find("solver");
  if (solver && *solver == OptionValue(clusterSolverNames.nameOf(ClusterSolver::cholesky)))
    return "a GPU solves implicit clusters by conjugate gradients, not by \"cholesky\"";
  if (solver && *solver == OptionValue(Imex::newton))
    return "a GPU solves implicit clusters by conjugate gradients, not by \"newton\"";
  const OptionValue* momentum = own.find("momentum");
  if (momentum && *momentum == OptionValue(momentumChoices[0]))
    return "a GPU does not keep angular momentum: momentum must be \"free\"";
  const OptionValue* limit = own.find("energy_limit");
  if (limit && *limit != OptionValue(0))
    return "a GPU does not limit the energy that handled elements add: energy_limit must be 0";
  own.set("momentum", momentumChoices[1]);
  own.set("energy_limit", 0);
  own.set("solver", clusterSolverNames.nameOf(ClusterSolver::conjugateGradients));
  if (!own.find("tolerance") || own.automatic("tolerance")) own.set("tolerance", 1e-8);
  return {};
}

namespace {

/// What Newton's method leaves over works on the elements: at 2e-3, which linear solvers take, it fed half of what the
/// default dissipation takes, at 5e-4 a thirtieth.
constexpr double newtonTolerance = 5e-4;

bool hasNonlinearLaw(const Body& body) {
  return std::ranges::any_of(body.blocks(),
                             [](const auto& block) { return block->material().lawName() != LinearElastic::name; });
}

/// Whether the equations of the handled elements are to be nonlinear. They are linear where all laws are, and with
/// damping.
bool isNonlinear(const Body& body, std::string_view solver, bool damped) {
  return solver == "auto" ? !damped && hasNonlinearLaw(body) : solver == Imex::newton;
}

/// The options with the solver of linear clusters.
Options linearSolver(Options own) {
  if (own.text("solver") == Imex::newton || own.text("solver") == Imex::linear) own.set("solver", "auto");
  return own;
}

}  // namespace

class Imex::Corrected final : public SecondOrderSystem {
 public:
  /// inner: that of the body, asked where it damps; else the explicit and the handled elements are evaluated apart.
  /// first: its acceleration that is asked for first; empty when it is not known.
  Corrected(Imex& owner, SecondOrderSystem& inner, const ImplicitScheme& scheme, NodeVectors& first)
      : owner_(owner), inner_(inner), h_(scheme.h), c_(scheme.c()), first_(first) {}
  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    if (inner_.velocityDependent()) {
      if (first_.cols() > 0) {
        a.swap(first_);
        first_.resize(3, 0);
      } else {
        inner_.acceleration(time, x, v, a);
      }
      owner_.work().beginWithAll(x, a);
    } else {
      owner_.explicitAcceleration(x, a);
      if (owner_.nonlinear_)
        for (HandledWork& work : owner_.works()) work.begin(x, a);
      else
        owner_.work().beginAndAdd(x, a);
    }
    const auto solveAll = [&](auto& clusters, const auto& solve) {
      const auto failed =
          solveClusters(owner_.body_, clusters, owner_.freeOfTorque_, x, v, h_, a, owner_.reasons_, solve);
      std::optional<ElementRef> at;
      std::string text;
      Domain& domain = owner_.body_.domain();
      if (failed) {
        const auto& elements = clusters[failed->cluster].elements();
        at = elements.front();
        text = failed->text(elements.size(), domain.inWhole(*at));
      }
      if (domain.firstFound(at, text) && fault.empty()) fault = std::move(text);
    };
    if (owner_.nonlinear_)
      solveAll(owner_.newtonClusters_, [&](std::size_t k) { return owner_.newtonClusters_[k].solveOrTell(x, a, v); });
    else
      solveAll(owner_.clusters_, [&](std::size_t k) -> std::string_view {
        ImplicitCluster& cluster = owner_.clusters_[k];
        if (!cluster.follow(x)) return "the implicit matrix is not positive definite or not finite";
        return cluster.solve(a, v, c_) ? "" : "conjugate gradients did not converge";
      });
    for (HandledWork& work : owner_.works()) work.end(v, a);
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return c_ != 0 || inner_.velocityDependent(); }

  std::string fault;

 private:
  Imex& owner_;
  SecondOrderSystem& inner_;
  double h_, c_;
  NodeVectors& first_;
};

Imex::Imex(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : EnergyLimitedHandler(description, body, std::move(base), std::move(options)),
      dissipation_(options_.own.number("dissipation")),
      nonlinear_(isNonlinear(body, options_.own.text("solver"), options_.damping.any())),
      keepsMomentum_(ringwatch::keepsMomentum(options_.own)),
      cluster_(clusterOptionsOf(linearSolver(options_.own))) {
  if (nonlinear_ && options_.own.automatic("tolerance")) cluster_.tolerance = newtonTolerance;
  if (nonlinear_ && options_.damping.any())
    throw InputError("imex: the solver \"newton\" works without damping; take another");
  if (!nonlinear_ && !options_.damping.any() && hasNonlinearLaw(body)) limitEnergy(options_.own.number("energy_limit"));
}

void Imex::takeOwn(const NodeVectors& x, double h, const ElementFlags& chosen) {
  const ImplicitScheme scheme = schemeOf(h);
  for (const NewtonCluster& cluster : newtonClusters_) {
    countsBefore_.stalls += cluster.stalls();
    countsBefore_.eulerSteps += cluster.eulerSteps();
  }
  clusters_.clear();
  newtonClusters_.clear();
  freeOfTorque_.clear();
  const auto add = [&](const auto& cluster) {
    freeOfTorque_.push_back(keepsMomentum_ && isFreeOfTorque(body_, cluster.elements(), cluster.nodes()));
  };
  for (auto& elements : clustersOf(body_, chosenElements(chosen)))
    if (nonlinear_)
      add(newtonClusters_.emplace_back(body_, std::move(elements), scheme, cluster_.tolerance, cluster_.iterations));
    else
      add(clusters_.emplace_back(body_, std::move(elements), scheme.w(), x, cluster_));
  countWork(h);
  detach(chosen);
}

std::string Imex::whyNotInParts() const {
  if (!nonlinear_)
    return "handler.method: \"imex\" is distributed over ranks with nonlinear equations alone, and for these laws it "
           "takes linear ones; set handler.solver = \"newton\"";
  if (explicitBody().mesh().elementCount() == 0)
    return "integrator.step: the handler takes every element, which is not distributed over ranks; take a smaller "
           "step, "
           "or run the scene with one process, without mpirun";
  return {};
}

StepStatus Imex::ownStep(SecondOrderSystem& system, State& state, double h) {
  if (system.velocityDependent() && nonlinear_)
    throw InputError("imex: the solver \"newton\" works without damping, and the system has some");
  // With u = a + c v the damping force needs no product of its own: (M + w K̂) u = M (a₀ + c v).
  NodeVectors first(3, 0);
  if (handledBeginsWithAcceleration()) first.swap(state.a);
  Corrected corrected(*this, system, schemeOf(h), first);
  return baseStep(corrected, state, h, corrected.fault);
}

std::vector<HandlerFigure> Imex::figures() const {
  std::vector<HandlerFigure> result = imex() ? imex()->figures() : figuresOfClusters();
  if (!nonlinear_) result.push_back({"nonlinear_steps", static_cast<double>(imexSteps()), true});
  return result;
}

std::vector<HandlerFigure> Imex::figuresOfClusters() const {
  if (nonlinear_) {
    NewtonCounts counts = countsBefore_;
    for (const NewtonCluster& cluster : newtonClusters_) counts.add(cluster);
    counts.addOthers(body_.domain());
    return counts.figures();
  }
  std::size_t largest = 0;
  std::int64_t factorisations = 0, iterations = 0;
  for (const ImplicitCluster& cluster : clusters_) {
    largest = std::max(largest, cluster.nodes().size());
    factorisations += cluster.factorisations();
    iterations += cluster.iterations();
  }
  return {{"clusters", static_cast<double>(clusters_.size())},
          {"largest_cluster_nodes", static_cast<double>(largest)},
          {"factorisations", static_cast<double>(factorisations), true},
          {"iterations", static_cast<double>(iterations), true}};
}

}  // namespace ringwatch
