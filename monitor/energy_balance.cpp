#include <ringwatch/monitor/energy_balance.h>

#include <algorithm>

namespace ringwatch {

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
  x_ = x;
  if (body_.constraints().moving()) force_ = internalForce;
}

void EnergyBalance::recordDamping(double time, const NodeVectors& v, const NodeVectors& dampingForce) {
  DampingPower now{time, dampingForce.cwiseProduct(v).sum(), 0};
  if (body_.constraints().moving()) now.atSupports = dampingForce.cwiseProduct(body_.constraints().velocity()).sum();
  if (damping_) {
    const double half = 0.5 * (time - damping_->time);
    dissipated_ += half * (damping_->all + now.all);
    prescribedWork_ += half * (damping_->atSupports + now.atSupports);
  }
  damping_ = now;
}

Energies EnergyBalance::energies(const NodeVectors& v, double strainEnergy) {
  Energies e;
  e.kinetic = 0.5 * (v.colwise().squaredNorm() * body_.lumpedMass())(0, 0);
  e.strain = strainEnergy;
  // Dead forces at moved components do no work on the body that their support does not take back.
  NodeVectors load = body_.externalForce();
  body_.constraints().clearConstrained(load);
  e.externalWork = prescribedWork_ + load.cwiseProduct(x_ - firstX_).sum();
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
