#include <ringwatch/distributed/rank_energies.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <ringwatch/body/element_energy.h>
#include <ringwatch/monitor/mean_rate.h>

namespace ringwatch {

namespace {

/// Rounded the same for every node, wherever its column lies: a compiler may fuse an expression in some places only.
double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::fma(a[0], b[0], std::fma(a[1], b[1], a[2] * b[2]));
}

/// Adds this rank's terms of the kinetic and the strain energy.
void addEnergies(const RankBody& part, NodeVectorsView x, NodeVectorsView v, ExactSum& kinetic, ExactSum& strain) {
  const Body& body = part.body();
  for (std::int32_t i = 0; i < part.ownedNodes(); ++i) {
    kinetic.add(0.5 * body.lumpedMass()[i] * dot(v.col(i), v.col(i)));
  }
  const std::vector<std::vector<double>> energies = strainEnergyOfElements(body, x);
  for (std::size_t b = 0; b < energies.size(); ++b)
    for (std::size_t e = 0; e < energies[b].size(); ++e)
      if (part.counts({b, e})) strain.add(energies[b][e]);
}

}  // namespace

RankEnergies energiesOf(Ranks& ranks, const RankBody& part, NodeVectorsView x, NodeVectorsView v) {
  std::array<ExactSum, 2> sums;
  addEnergies(part, x, v, sums[0], sums[1]);
  ranks.sum(sums);
  return {sums[0].value(), sums[1].value()};
}

RankEnergyBalance::RankEnergyBalance(Ranks& ranks, const RankBody& part, bool moving)
    : ranks_(ranks), part_(part), moving_(moving) {
  work_.setZero(part.ownedNodes());
  dissipated_.setZero(part.ownedNodes());
}

void RankEnergyBalance::record(const NodeVectors& x, const NodeVectors& internalForce) {
  const std::int32_t owned = part_.ownedNodes();
  const Constraints& constraints = part_.body().constraints();
  if (!started_) {
    firstX_ = x.leftCols(owned);
    started_ = true;
  } else if (moving_) {
    for (std::int32_t i = 0; i < owned; ++i)
      for (int c = 0; c < 3; ++c)
        if (constraints.isConstrained(i, c) && constraints.velocity()(c, i) != 0)
          work_[i] = std::fma(meanRate(lastForce_(c, i), internalForce(c, i)), x(c, i) - lastX_(c, i), work_[i]);
  }
  if (!moving_) return;
  lastX_ = x.leftCols(owned);
  lastForce_ = internalForce.leftCols(owned);
}

void RankEnergyBalance::recordDamping(double time, const NodeVectors& v, const NodeVectors& dampingForce) {
  const std::int32_t owned = part_.ownedNodes();
  Eigen::VectorXd power(owned), atSupports(owned);
  const double passed = dampedAt_ ? time - *dampedAt_ : 0;
  for (std::int32_t i = 0; i < owned; ++i) {
    power[i] = dot(dampingForce.col(i), v.col(i));
    atSupports[i] = dot(dampingForce.col(i), part_.body().constraints().velocity().col(i));
    if (!dampedAt_) continue;
    dissipated_[i] = std::fma(passed, meanRate(dampingPower_[i], power[i]), dissipated_[i]);
    work_[i] = std::fma(passed, meanRate(supportPower_[i], atSupports[i]), work_[i]);
  }
  dampedAt_ = time;
  dampingPower_ = std::move(power);
  supportPower_ = std::move(atSupports);
}

Energies RankEnergyBalance::energies(const NodeVectors& x, const NodeVectors& v) {
  enum : std::size_t { kinetic, strain, external, dissipated };
  std::array<ExactSum, 4> sums;
  addEnergies(part_, x, v, sums[kinetic], sums[strain]);
  const Body& body = part_.body();
  for (std::int32_t i = 0; i < part_.ownedNodes(); ++i) {
    double work = work_[i];
    // Dead forces at constrained components do no work on the body that their support does not take back.
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c))
        work = std::fma(body.externalForce()(c, i), x(c, i) - firstX_(c, i), work);
    sums[external].add(work);
    sums[dissipated].add(dissipated_[i]);
  }
  ranks_.sum(sums);
  Energies e;
  e.kinetic = sums[kinetic].value();
  e.strain = sums[strain].value();
  e.externalWork = sums[external].value();
  e.dissipated = sums[dissipated].value();
  const double total = e.kinetic + e.strain + e.dissipated - e.externalWork;
  if (!reference_ && std::isfinite(total)) reference_ = total;
  e.balanceError = total - reference_.value_or(0);
  return e;
}

NodeVectors gathered(Ranks& ranks, const RankBody& part, NodeVectorsView vectors) {
  const int size = ranks.size(), own = part.ownedNodes();
  const bool root = ranks.rank() == 0;
  std::vector<int> counts(size), begins(size + 1, 0);
  MPI_Gather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, ranks.communicator());
  for (int r = 0; r < size; ++r) begins[r + 1] = begins[r] + counts[r];
  const int all = root ? begins[size] : 0;
  std::vector<std::int32_t> nodes(all);
  MPI_Gatherv(part.globalNodes().data(), own, MPI_INT32_T, nodes.data(), counts.data(), begins.data(), MPI_INT32_T, 0,
              ranks.communicator());
  // Of vectors, so that counts are those of nodes.
  MPI_Datatype vector = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(3, MPI_DOUBLE, &vector);
  MPI_Type_commit(&vector);
  NodeVectors inOrderOfRanks(3, all), result(3, all);
  MPI_Gatherv(vectors.data(), own, vector, inOrderOfRanks.data(), counts.data(), begins.data(), vector, 0,
              ranks.communicator());
  MPI_Type_free(&vector);
  for (int i = 0; i < all; ++i) result.col(nodes[i]) = inOrderOfRanks.col(i);
  return result;
}

}  // namespace ringwatch
