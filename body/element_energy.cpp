#include <ringwatch/body/element_energy.h>

#include <ringwatch/base/parallel.h>

namespace ringwatch {

std::vector<std::vector<double>> strainEnergyOfElements(const Body& body, NodeVectorsView x) {
  std::vector<std::vector<double>> energies;
  for (const auto& each : body.blocks()) {
    const ElementBlock& block = *each;
    const PatchLayout& layout = block.layout();
    std::vector<double>& own = energies.emplace_back(block.elementCount());
    parallelFor(0, static_cast<std::int64_t>(layout.patches.size()), body.threads(), [&](std::int64_t p) {
      const Patch& patch = layout.patches[p];
      alignas(64) double rows[4 * PatchLayout::maxPatchNodes];
      block.gatherRows(patch, x.data(), rows);
      for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
        alignas(64) double ofLanes[lanes] = {};
        block.evaluateBatches(batch, batch + 1, rows, {.energy = ofLanes});
        for (int lane = 0; lane < lanes; ++lane)
          if (const std::int32_t e = layout.elements[batch * lanes + lane]; e >= 0) own[e] = ofLanes[lane];
      }
    });
  }
  return energies;
}

std::vector<double> volumeOfElements(const Body& body) {
  std::vector<double> volumes(body.mesh().elementCount());
  std::size_t first = 0;
  for (const auto& each : body.blocks()) {
    const PatchLayout& layout = each->layout();
    double ofLanes[lanes];
    for (std::int32_t batch = 0; batch < layout.batchCount(); ++batch) {
      each->volumeBatch(batch, ofLanes);
      for (int lane = 0; lane < lanes; ++lane)
        if (const std::int32_t e = layout.elements[batch * lanes + lane]; e >= 0)
          volumes[first + static_cast<std::size_t>(e)] = ofLanes[lane];
    }
    first += static_cast<std::size_t>(each->elementCount());
  }
  return volumes;
}

Eigen::VectorXd lumpedMassOfElements(const Body& body, const std::vector<ElementRef>& elements) {
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(body.nodeCount());
  double mass[maxElementNodes];
  for (const ElementRef e : elements) {
    body.elementLumpedMass(e, mass);
    const auto nodes = body.blocks()[e.block]->nodesOf(e.element);
    for (std::size_t a = 0; a < nodes.size(); ++a) nodal[nodes[a]] += mass[a];
  }
  return nodal;
}

}  // namespace ringwatch
