#include <ringwatch/body/tangent_block.h>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {
constexpr int lanes = PatchLayout::lanes;
}

TangentBlock::TangentBlock(const Mesh& mesh, const MeshBlock& block)
    : ElementBlock(mesh, block, Material{}, elementInfo(block.type).rules.front()) {}

void TangentBlock::tangentBatch(std::int32_t batch, const double* x, double* K) const {
  tangentOf(layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, x, K);
}

void TangentBlock::tangentOf(const std::int32_t* elements, const double* /*x*/, double* K) const {
  const std::ptrdiff_t size = 3 * element().nodes, count = size * size;
  for (int lane = 0; lane < lanes; ++lane) {
    const double* own = tangents_ + (elements[lane] < 0 ? 0 : elements[lane]) * count;
    for (std::ptrdiff_t i = 0; i < count; ++i) K[i * lanes + lane] = elements[lane] < 0 ? 0.0 : own[i];
  }
}

void TangentBlock::tangentProductBatches(std::int32_t first, std::int32_t last, const double* /*rows*/,
                                         const double* vRows, double* slots) const {
  const int n = element().nodes, size = 3 * n;
  const auto& layout = this->layout();
  for (std::int32_t i = first * lanes; i < last * lanes; ++i) {
    const std::int32_t e = layout.elements[static_cast<std::size_t>(i)];
    if (e < 0) continue;
    const double* K = tangents_ + static_cast<std::ptrdiff_t>(e) * size * size;
    const auto local = [&](int a) {
      return 4 * static_cast<std::ptrdiff_t>(
                     layout.localNodes[static_cast<std::size_t>((i / lanes * n + a) * lanes + i % lanes)]);
    };
    double own[3 * maxElementNodes];
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 3; ++c) own[3 * a + c] = vRows[local(a) + c];
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int k = 0; k < size; ++k) sum += K[(3 * a + c) * size + k] * own[k];
        slots[local(a) + c] += sum;
      }
  }
}

void TangentBlock::unknown(const char* what) {
  throw NumericalError(joinText("elements that are known by their tangents alone have no ", what));
}

}  // namespace ringwatch
