#include <ringwatch/monitor/incremental/laplacian_majorants.h>

#include <algorithm>
#include <cmath>

namespace ringwatch {
namespace {

/// Iterations for the vector that scales the Laplacian (Collatz-Wielandt): later ones gain hardly anything on any mesh.
constexpr int sweeps = 25;
/// Of sums of a few products, relative.
constexpr double sumRounding = 1e-12;

}  // namespace

std::vector<std::vector<double>> laplacianMajorants(const Body& body) {
  const std::int32_t count = body.nodeCount();
  const Eigen::VectorXd& mass = body.lumpedMass();
  Eigen::VectorXd u = Eigen::VectorXd::Ones(count), product(count);
  for (std::int32_t i = 0; i < count; ++i)
    if (body.constraints().any() && body.constraints().freeComponents(i) == 0) u[i] = 0;
  // |L_ab| and its rounding, of each block: [place][a][b].
  std::vector<std::vector<double>> matrices;
  for (const auto& block : body.blocks()) {
    const int n = block->nodesPerElement();
    std::vector<double>& entries = matrices.emplace_back(block->layout().elements.size() * n * n);
    AlignedVector<NativePack> L(static_cast<std::size_t>(n * n)), T(static_cast<std::size_t>(n));
    for (std::int32_t batch = 0; batch < block->layout().batchCount(); ++batch) {
      const std::int32_t* elements = block->layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
      if (elements[0] < 0) continue;
      block->laplacianOf(elements, reinterpret_cast<double*>(L.data()), reinterpret_cast<double*>(T.data()));
      for (int lane = 0; lane < lanes && elements[lane] >= 0; ++lane) {
        double* entry = entries.data() + (static_cast<std::size_t>(batch) * lanes + lane) * n * n;
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b) *entry++ = std::abs(L[a * n + b][lane]) + std::sqrt(T[a][lane] * T[b][lane]);
      }
    }
  }
  // Σ_b |L_ab| u_b of each element at its nodes: take(block, place, a, node, sum).
  const auto forEachRow = [&](const auto& take) {
    for (std::size_t b = 0; b < body.blocks().size(); ++b) {
      const ElementBlock& block = *body.blocks()[b];
      const double* entry = matrices[b].data();
      const int n = block.nodesPerElement();
      for (std::size_t place = 0; place < block.layout().elements.size(); ++place) {
        if (block.layout().elements[place] < 0) {
          entry += n * n;
          continue;
        }
        const auto nodes = block.nodesOf(block.layout().elements[place]);
        for (int a = 0; a < n; ++a) {
          double sum = 0;
          for (int c = 0; c < n; ++c) sum += *entry++ * u[nodes[c]];
          take(b, place, a, nodes[a], sum);
        }
      }
    }
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    product.setZero();
    forEachRow([&](std::size_t, std::size_t, int, std::int32_t node, double sum) { product[node] += sum; });
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
  forEachRow([&](std::size_t b, std::size_t place, int a, std::int32_t node, double sum) {
    const auto n = static_cast<std::size_t>(body.blocks()[b]->nodesPerElement());
    majorants[b][(place / lanes * n + static_cast<std::size_t>(a)) * lanes + place % lanes] =
        u[node] > 0 ? sum / u[node] * (1 + sumRounding) : 0;
  });
  return majorants;
}

}  // namespace ringwatch
