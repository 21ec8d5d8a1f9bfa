#include <ringwatch/handlers/imex/imex.h>

#include <algorithm>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/handlers/angular_momentum.h>
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
        owner_.work().begin(x, a);
      else
        owner_.work().beginAndAdd(x, a);
    }
    if (owner_.nonlinear_)
      forEachCluster(owner_.newtonClusters_, x, v, a, [&](NewtonCluster& cluster) -> std::string_view {
        switch (cluster.solve(x, a, v)) {
          case NewtonCluster::Outcome::solved:
            return {};
          case NewtonCluster::Outcome::noEnergy:
            return "the implicit elements have no finite energy";
          case NewtonCluster::Outcome::notConverged:
            break;
        }
        return "Newton's method did not converge";
      });
    else
      forEachCluster(owner_.clusters_, x, v, a, [&](ImplicitCluster& cluster) -> std::string_view {
        if (!cluster.follow(x)) return "the implicit matrix is not positive definite or not finite";
        return cluster.solve(a, v, c_) ? "" : "conjugate gradients did not converge";
      });
    owner_.work().end(v, a);
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return c_ != 0 || inner_.velocityDependent(); }

  std::string fault;

 private:
  /// Has all clusters solved, large ones by all threads, the others side by side; solve tells what went wrong, "" for
  /// nothing.
  template <class Cluster, class Solve>
  void forEachCluster(std::vector<Cluster>& clusters, const NodeVectors& x, const NodeVectors& v, NodeVectors& a,
                      const Solve& solve) {
    auto& failed = owner_.failed_;
    failed.assign(clusters.size(), {});
    const auto visit = [&](std::int64_t k) {
      const auto& nodes = clusters[k].nodes();
      if (!owner_.freeOfTorque_[k]) {
        failed[k] = solve(clusters[k]);
        return;
      }
      const NodeVectors before = a(Eigen::all, nodes);
      failed[k] = solve(clusters[k]);
      if (failed[k].empty()) keepAngularMomentum(owner_.body_, nodes, x, v, h_, before, a);
    };
    for (std::size_t k = 0; k < clusters.size(); ++k)
      if (takesAllThreads(clusters[k])) visit(static_cast<std::int64_t>(k));
    parallelFor(0, clusters.size(), owner_.body_.threads(), [&](std::int64_t k) {
      if (!takesAllThreads(clusters[k])) visit(k);
    });
    for (std::size_t k = 0; k < clusters.size() && fault.empty(); ++k)
      if (!failed[k].empty()) {
        const ElementRef first = clusters[k].elements().front();
        fault = joinText(failed[k], " in the cluster of ", clusters[k].elements().size(), " elements at element ",
                         first.block, ":", first.element);
      }
  }

  static bool takesAllThreads(const NewtonCluster& cluster) { return cluster.threads() != 1; }
  static bool takesAllThreads(const ImplicitCluster&) { return false; }

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
    stallsBefore_ += cluster.stalls();
    eulerStepsBefore_ += cluster.eulerSteps();
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
  const auto largestOf = [](const auto& clusters) {
    std::size_t largest = 0;
    for (const auto& cluster : clusters) largest = std::max(largest, cluster.nodes().size());
    return static_cast<double>(largest);
  };
  std::int64_t rounds = 0, iterations = 0;
  for (const ImplicitCluster& cluster : clusters_) {
    rounds += cluster.factorisations();
    iterations += cluster.iterations();
  }
  std::int64_t stalls = stallsBefore_, eulerSteps = eulerStepsBefore_;
  for (const NewtonCluster& cluster : newtonClusters_) {
    rounds += cluster.iterations();
    iterations += cluster.products();
    stalls += cluster.stalls();
    eulerSteps += cluster.eulerSteps();
  }
  std::vector<HandlerFigure> result{
      {"clusters", static_cast<double>(clusters_.size() + newtonClusters_.size())},
      {"largest_cluster_nodes", std::max(largestOf(clusters_), largestOf(newtonClusters_))},
      {nonlinear_ ? "newton_iterations" : "factorisations", static_cast<double>(rounds), true},
      {"iterations", static_cast<double>(iterations), true}};
  if (nonlinear_) {
    result.push_back({"stalled_searches", static_cast<double>(stalls)});
    result.push_back({"implicit_euler_steps", static_cast<double>(eulerSteps)});
  }
  return result;
}

}  // namespace ringwatch
