#include <ringwatch/verify/integrators/oscillator_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <ringwatch/base/random.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using detail::nan;

/// p and its derivatives.
struct Driven {
  explicit Driven(double t)
      : x(std::sin(t) + std::cos(2 * t) / 4), v(std::cos(t) - std::sin(2 * t) / 2), a(-std::sin(t) - std::cos(2 * t)) {}
  double x, v, a;
};

/// Systems of oscillators without coupling: of unit mass, with a diagonal stiffness.
class DiagonalSystem : public DifferentiableSystem {
 public:
  explicit DiagonalSystem(Eigen::Index nodes) : mass_(Eigen::VectorXd::Ones(nodes)) {}
  const Eigen::VectorXd& mass() const override { return mass_; }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    Ku = diagonal(x).cwiseProduct(u);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override {
    const NodeVectors k = diagonal(x);
    return Eigen::SparseMatrix<double>(Eigen::Map<const Eigen::VectorXd>(k.data(), k.size()).asDiagonal());
  }

 protected:
  virtual NodeVectors diagonal(const NodeVectors& x) const = 0;

 private:
  Eigen::VectorXd mass_;
};

/// p̈ + p + p³ - k x - x³.
class DrivenOscillator final : public DiagonalSystem {
 public:
  explicit DrivenOscillator(double k) : DiagonalSystem(1), k_(k) {}
  void acceleration(double time, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    const Driven p(time);
    a = (p.a + p.x + p.x * p.x * p.x - k_ * x.array() - x.array().cube()).matrix();
  }

 private:
  NodeVectors diagonal(const NodeVectors& x) const override { return (k_ + 3 * x.array().square()).matrix(); }
  double k_;
};

/// A frequency, a start and a force of time; components of a field take them in turn.
struct Kind {
  double omega, x, v, force, rate;
};
constexpr std::array kinds{Kind{1, 1, 0.5, 0.3, 1.1},      Kind{0.4, -0.7, 1.2, -0.8, 0.3},
                           Kind{1.7, 0.2, -1.1, 0.5, 2.3}, Kind{0.9, -1.3, -0.6, 0.7, 1.9},
                           Kind{1.3, 0.8, 0.9, -0.4, 0.7}, Kind{0.2, 1.4, -0.3, 0.6, 1.5},
                           Kind{1.9, -0.5, 0.4, 0.9, 2.9}};

/// A field of oscillators with a share of their stiffness, and with their forces, their damping or both.
struct FieldOptions {
  NodeVectors amplitudes;  // of each component, 0 for one that stays at rest
  std::size_t first = 0;   // the kind of the first component
  double speed = 0;        // of the frame, over the amplitude
  double alpha = 0;        // 1/s
};
class FieldPart final : public DiagonalSystem {
 public:
  FieldPart(const FieldOptions& field, double share, bool driven, double alpha)
      : DiagonalSystem(field.amplitudes.cols()), field_(field), share_(share), alpha_(alpha), driven_(driven) {}
  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    a.resize(3, x.cols());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const Kind& kind = kindOf(field_, i);
      const double s = field_.amplitudes.data()[i], u = s * field_.speed;
      double& sum = a.data()[i];
      sum = -share_ * kind.omega * kind.omega * (x.data()[i] - u * time);
      if (driven_) sum += s * kind.force * std::sin(kind.rate * time);
      if (alpha_ != 0) sum -= alpha_ * (v.data()[i] - u);
    }
  }
  bool velocityDependent() const override { return alpha_ != 0; }
  RayleighDamping damping() const override { return {alpha_, 0}; }
  int threads() const override { return 2; }

  static const Kind& kindOf(const FieldOptions& field, Eigen::Index i) {
    return kinds[(field.first + static_cast<std::size_t>(i)) % kinds.size()];
  }

 private:
  NodeVectors diagonal(const NodeVectors& x) const override {
    NodeVectors k(3, x.cols());
    for (Eigen::Index i = 0; i < k.size(); ++i) k.data()[i] = share_ * std::pow(kindOf(field_, i).omega, 2);
    return k;
  }
  FieldOptions field_;
  double share_, alpha_;
  bool driven_;
};

class AdditiveParts final : public AdditiveSystem {
 public:
  AdditiveParts(std::unique_ptr<SecondOrderSystem> nonstiff, std::unique_ptr<DifferentiableSystem> stiff)
      : nonstiff_(std::move(nonstiff)), stiff_(std::move(stiff)) {}
  SecondOrderSystem& nonstiff() override { return *nonstiff_; }
  DifferentiableSystem& stiff() override { return *stiff_; }
  bool velocityDependent() const override { return stiff_->velocityDependent(); }

 private:
  std::unique_ptr<SecondOrderSystem> nonstiff_;
  std::unique_ptr<DifferentiableSystem> stiff_;
};

double larger(double a, double b) { return std::isnan(a) || std::isnan(b) ? nan : std::max(a, b); }
double largest(const NodeVectors& v) { return v.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(); }

/// A field's states after each of three steps from t = 3, as seen from its frame; none where a step fails. left:
/// becomes the largest difference, over the amplitudes, of State::a from the acceleration.
std::vector<State> fieldStates(Integrator& integrator, const FieldOptions& field, bool byAdvance, double& left) {
  constexpr int steps = 3;
  constexpr double h = 0.1;
  std::unique_ptr<SecondOrderSystem> system = std::make_unique<FieldPart>(field, 1, true, field.alpha);
  if (integrator.info().partitioned)
    system = std::make_unique<AdditiveParts>(std::make_unique<FieldPart>(field, 0.5, true, 0),
                                             std::make_unique<FieldPart>(field, 0.5, false, field.alpha));
  const NodeVectors u = field.speed * field.amplitudes;
  State state;
  state.time = 3;
  state.x = state.v = field.amplitudes;
  for (Eigen::Index i = 0; i < state.x.size(); ++i) {
    state.x.data()[i] *= FieldPart::kindOf(field, i).x;
    state.v.data()[i] *= FieldPart::kindOf(field, i).v;
  }
  state.x += state.time * u;
  state.v += u;
  std::vector<State> states;
  NodeVectors a;
  for (int k = 0; k < steps; ++k) {
    if (!(byAdvance ? integrator.advance(*system, state, h) : integrator.step(*system, state, h)).done) return {};
    if (byAdvance) complete(*system, state);
    left = larger(left, std::abs(state.lag));
    if (state.a.cols() > 0 && !system->velocityDependent()) {
      system->acceleration(state.time, state.x, state.v, a);
      left = larger(left, largest(state.a - a));
    }
    State& seen = states.emplace_back(state);
    seen.x -= state.time * u;
    seen.v -= u;
  }
  return states;
}

/// The largest difference of two motions, over the amplitudes.
double difference(const std::vector<State>& a, const std::vector<State>& b, const NodeVectors& amplitudes) {
  double most = a.empty() || a.size() != b.size() ? nan : 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    most = larger(most, larger(largest((a[k].x - b[k].x).cwiseQuotient(amplitudes)),
                               largest((a[k].v - b[k].v).cwiseQuotient(amplitudes))));
  return most;
}

}  // namespace

double drivenError(const IntegratorFactory& make, int steps) {
  const std::unique_ptr<Integrator> integrator = make();
  std::unique_ptr<SecondOrderSystem> system = std::make_unique<DrivenOscillator>(1);
  if (integrator->info().partitioned)
    system = std::make_unique<AdditiveParts>(std::make_unique<DrivenOscillator>(0.5),
                                             std::make_unique<Oscillator>(std::sqrt(0.5)));
  State state;
  state.time = 0.5;
  const Driven start(state.time), end(1.5);
  state.x = NodeVectors::Constant(3, 1, start.x);
  state.v = NodeVectors::Constant(3, 1, start.v);
  for (int k = 0; k < steps; ++k)
    if (!integrator->step(*system, state, 1.0 / steps).done) return nan;
  return std::hypot(state.x(0, 0) - end.x, state.v(0, 0) - end.v);
}

double measureDrivenOrder(const IntegratorFactory& make) {
  const double least = make()->info().forceEvaluations > 0 ? 1e-11 : 1e-10;  // what iterations leave: 2e-11
  return orderOf([&](int steps) { return drivenError(make, steps); }, least);
}

FieldErrors fieldErrors(const IntegratorFactory& make, int nodes, double dampingRatio) {
  FieldErrors errors{0, 0, 0};
  Random random(3);
  FieldOptions field{NodeVectors(3, nodes), 0, 0, 2 * dampingRatio};
  for (double& amplitude : field.amplitudes.reshaped()) amplitude = random.uniform(0.5, 2);
  const auto states = [&](const FieldOptions& of, bool byAdvance) {
    return fieldStates(*make(), of, byAdvance, errors.left);
  };
  const std::vector<State> seen = states(field, false);
  std::vector<State> alone = seen;
  FieldOptions one{NodeVectors::Zero(3, 1), 0, 0, field.alpha};
  one.amplitudes(0, 0) = 1;
  for (; one.first < kinds.size(); ++one.first) {
    const std::vector<State> reference = states(one, false);
    for (std::size_t k = 0; k < alone.size(); ++k)
      for (auto i = static_cast<Eigen::Index>(one.first); i < alone[k].x.size(); i += kinds.size()) {
        alone[k].x.data()[i] = reference.empty() ? nan : field.amplitudes.data()[i] * reference[k].x(0, 0);
        alone[k].v.data()[i] = reference.empty() ? nan : field.amplitudes.data()[i] * reference[k].v(0, 0);
      }
  }
  errors.components = difference(seen, alone, field.amplitudes);
  errors.left = larger(errors.left, difference(seen, states(field, true), field.amplitudes));
  FieldOptions moving = field;
  moving.speed = 0.7;
  errors.frame = difference(seen, states(moving, false), field.amplitudes);
  return errors;
}

}  // namespace ringwatch
