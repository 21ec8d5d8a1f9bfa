#include <ringwatch/body/domain.h>

#include <array>

#include <ringwatch/meshes/all_finite.h>

namespace ringwatch {

Domain& wholeDomain() {
  static Domain whole;
  return whole;
}

bool ownFinite(const Body& body, NodeVectorsView values) {
  return allFinite(NodeVectorsView(values.data(), body.domain().owned(values.cols())), body.threads());
}

SizeOfWhole sizeOfWhole(const Body& body) {
  Domain& domain = body.domain();
  if (domain.whole()) return {body.volume(), static_cast<double>(body.elementCount())};
  std::array<ExactSum, 2> sums;  // volumes, and ones
  double volumes[lanes];
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    const ElementBlock& block = *body.blocks()[b];
    for (std::int32_t batch = 0; batch < block.layout().batchCount(); ++batch) {
      block.volumeBatch(batch, volumes);
      for (int lane = 0; lane < lanes; ++lane)
        if (const std::int32_t e = block.layout().elements[batch * lanes + lane]; e >= 0 && domain.counts({b, e})) {
          sums[0].add(volumes[lane]);
          sums[1].add(1);
        }
    }
  }
  domain.sum(sums);
  return {sums[0].value(), sums[1].value()};
}

}  // namespace ringwatch
