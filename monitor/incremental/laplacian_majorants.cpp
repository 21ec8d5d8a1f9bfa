#include <ringwatch/monitor/incremental/laplacian_majorants.h>

#include <algorithm>
#include <cmath>

namespace ringwatch {
namespace {

/// Iterations for the vector that scales the Laplacian (Collatz-Wielandt): later ones gain little on any mesh.
constexpr int sweeps = 5;
/// Of sums of a few products, relative.
constexpr double sumRounding = 1e-12;

}  // namespace

std::vector<std::vector<double>> laplacianMajorants(const Body& body) {
  const std::int32_t count = body.nodeCount();
  const Eigen::VectorXd& mass = body.lumpedMass();
  Eigen::VectorXd u = Eigen::VectorXd::Ones(count), product(count);
  for (std::int32_t i = 0; i < count; ++i)
    if (body.constraints().any() && body.constraints().freeComponents(i) == 0) u[i] = 0;
  // Σ_b |L_ab| u_b of each element at its nodes: take(block, place of a in it, node, sum).
  const auto forEachRow = [&](const auto& take) {
    for (std::size_t b = 0; b < body.blocks().size(); ++b) {
      const ElementBlock& block = *body.blocks()[b];
      const int n = block.nodesPerElement();
      AlignedVector<NativePack> L(static_cast<std::size_t>(n * n)), T(static_cast<std::size_t>(n));
      for (std::int32_t batch = 0; batch < block.layout().batchCount(); ++batch) {
        const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
        if (elements[0] < 0) continue;
        block.laplacianOf(elements, reinterpret_cast<double*>(L.data()), reinterpret_cast<double*>(T.data()));
        for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane) {
          const auto nodes = block.nodesOf(elements[lane]);
          for (int a = 0; a < n; ++a) {
            double sum = 0;
            for (int c = 0; c < n; ++c)
              sum += (std::abs(L[a * n + c][lane]) + std::sqrt(T[a][lane] * T[c][lane])) * u[nodes[c]];
            take(b, (static_cast<std::size_t>(batch) * static_cast<std::size_t>(n) + a) * lanes + lane, nodes[a], sum);
          }
        }
      }
    }
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    product.setZero();
    forEachRow([&](std::size_t, std::size_t, std::int32_t node, double sum) { product[node] += sum; });
    double highest = 0;
    for (std::int32_t i = 0; i < count; ++i)
      if (u[i] > 0 && mass[i] > 0) highest = std::max(highest, product[i] / (mass[i] * u[i]));
    // Half a step of the power method, with a share of what was: so vectors neither swing nor vanish.
    for (std::int32_t i = 0; i < count; ++i)
      if (u[i] > 0 && mass[i] > 0) u[i] = 0.5 * (u[i] + product[i] / (mass[i] * highest));
  }
  std::vector<std::vector<double>> majorants;
  for (const auto& block : body.blocks())
    majorants.emplace_back(block->layout().elements.size() * static_cast<std::size_t>(block->nodesPerElement()), 0.0);
  forEachRow([&](std::size_t b, std::size_t at, std::int32_t node, double sum) {
    majorants[b][at] = u[node] > 0 ? sum / u[node] * (1 + sumRounding) : 0;
  });
  return majorants;
}

}  // namespace ringwatch
