#include <ringwatch/monitor/energy_balance.h>

#include <algorithm>

namespace ringwatch {

namespace {

/// The columns of a range of nodes.
auto nodes(const NodeVectors& all, Eigen::Index begin, Eigen::Index end) { return all.middleCols(begin, end - begin); }

/// Copies 3×N numbers in parallel.
void copyNodes(const NodeVectors& from, NodeVectors& to, int threads) {
  constexpr Eigen::Index grain = 1024;  // nodes a thread
  to.resizeLike(from);
  parallelParts(from.cols(), threads, grain, [&](Eigen::Index begin, Eigen::Index end) {
    to.middleCols(begin, end - begin) = nodes(from, begin, end);
  });
}

/// Σ a·b over all nodes.
double dot(const NodeVectors& a, const NodeVectors& b, int threads) {
  return parallelSum(a.cols(), threads, [&](Eigen::Index begin, Eigen::Index end) {
    return nodes(a, begin, end).cwiseProduct(nodes(b, begin, end)).sum();
  });
}

}  // namespace

double roundingEnergy(const Body& body) {
  constexpr double strain = 1e-12;
  double modulus = 0;
  for (const auto& block : body.blocks()) modulus = std::max(modulus, block->material().restModulus());
  return strain * strain * modulus * body.volume();
}

void EnergyBalance::record(const NodeVectors& x, const NodeVectors& internalForce) {
  if (!started_) {
    firstX_ = x;
    started_ = true;
  } else if (body_.constraints().moving()) {
    const NodeVectors& moved = body_.constraints().velocity();
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (moved.data()[i] != 0)
        prescribedWork_ += 0.5 * (force_.data()[i] + internalForce.data()[i]) * (x.data()[i] - x_.data()[i]);
  }
  copyNodes(x, x_, body_.threads());
  if (body_.constraints().moving()) copyNodes(internalForce, force_, body_.threads());
}

void EnergyBalance::recordDamping(double time, const NodeVectors& v, const NodeVectors& dampingForce) {
  DampingPower now{time, dot(dampingForce, v, body_.threads()), 0};
  if (body_.constraints().moving()) now.atSupports = dot(dampingForce, body_.constraints().velocity(), body_.threads());
  if (damping_) {
    const double half = 0.5 * (time - damping_->time);
    dissipated_ += half * (damping_->all + now.all);
    prescribedWork_ += half * (damping_->atSupports + now.atSupports);
  }
  damping_ = now;
}

Energies EnergyBalance::energies(const NodeVectors& v, double strainEnergy) {
  Energies e;
  e.kinetic = 0.5 * parallelSum(v.cols(), body_.threads(), [&](Eigen::Index begin, Eigen::Index end) {
                return nodes(v, begin, end)
                    .colwise()
                    .squaredNorm()
                    .dot(body_.lumpedMass().segment(begin, end - begin).transpose());
              });
  e.strain = strainEnergy;
  // Dead forces at moved components do no work on the body that their support does not take back.
  copyNodes(body_.externalForce(), load_, body_.threads());
  body_.constraints().clearConstrained(load_);
  e.externalWork =
      prescribedWork_ + parallelSum(x_.cols(), body_.threads(), [&](Eigen::Index begin, Eigen::Index end) {
        return nodes(load_, begin, end).cwiseProduct(nodes(x_, begin, end) - nodes(firstX_, begin, end)).sum();
      });
  e.dissipated = dissipated_;
  if (!hasReference_) {
    referenceEnergy_ = e.kinetic + e.strain + e.dissipated - e.externalWork;
    hasReference_ = true;
  }
  e.balanceError = e.kinetic + e.strain + e.dissipated - e.externalWork - referenceEnergy_;
  return e;
}

Energies EnergyBalance::evaluate(const NodeVectors& x, const NodeVectors& v) {
  own_.wantsForce = body_.constraints().moving();
  own_.wantsEnergy = true;
  body_.evaluate(x, own_, workspace_);
  record(x, own_.internalForce);
  return energies(v, own_.strainEnergy);
}

}  // namespace ringwatch
