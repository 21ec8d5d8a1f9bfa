#pragma once
#include <variant>

#include <bench/flops.h>
#include <bench/support.h>

namespace ringwatch::bench {

enum class Pass { force, product, tangent, assembly };

/// Operations of an element counted by running the law's own source on numbers that count, and the least bytes:
/// geometry, places of nodes, each nodal vector once, and what the pass writes.
inline Need needOf(const Case& c, const Setup& s, Pass pass) {
  const ElementBlock& block = *s.body.blocks()[0];
  const double n = block.element().nodes, points = static_cast<double>(block.rule().points.size());
  const bool tet = block.element().name == "tet4";
  const double gradient = tet ? 9 : 18 * n - 9, scatter = tet ? 15 : 18 * n, product = 45;
  Matrix3<Counted> F = Matrix3<Counted>::identity(), dF = F;
  F(0, 0) = 1.1;
  F(1, 2) = 0.1;
  double flops = 0;
  std::visit(
      [&](const auto& law) {
        const auto linearization = law.linearize(F);
        if (pass == Pass::force)
          flops = gradient + product + operationsOf([&] { law.stress(F); }) + 9 + product + scatter;
        else if (pass == Pass::product)
          flops = 2 * (gradient + product) + operationsOf([&] { law.linearize(F)(dF); }) + 9 + product + scatter;
        else {
          const Counted g[3] = {1.0, 0.5, 0.25};
          const auto blocks = nodeBlocksOf<Counted>(linearization, Counted(1.0));
          const auto node = blocks.node(g);
          flops = gradient + product + 15 * n +
                  operationsOf([&] { nodeBlocksOf<Counted>(law.linearize(F), Counted(1.0)); }) +
                  n * operationsOf([&] { blocks.node(g); }) +
                  n * (n + 1) / 2 * (operationsOf([&] { blocks(node, node); }) + (points > 1 ? 9 : 0));
        }
      },
      makeMaterial(c.law, 30e3, 0.3, 1000).law);
  flops *= points;
  // One-point hexahedra (elements/hourglass.h): two transforms of 24 sums for each of three components, F̄ and its
  // forces from six modes, four hourglass coordinates and their forces.
  const bool uniform = block.rule().uniformStrain;
  if (uniform && pass != Pass::tangent && pass != Pass::assembly)
    flops +=
        (pass == Pass::product ? 3 : 2) * 3 * 24 + 2 * 108 + 4 * (18 + 3 + 18 + 3) - gradient - scatter - 2 * product;
  // Into the nodes' slots, or the pairs'.
  if (pass == Pass::force || pass == Pass::product) flops += 3 * n;
  if (pass == Pass::assembly) flops += 9 * n * (n + 1) / 2;
  const double perElement = 1.0 / static_cast<double>(s.body.mesh().elementCount());
  double bytes =
      (uniform ? 256 : 80 * points) + 2 * n + 24 * s.body.nodeCount() * perElement * (pass == Pass::tangent ? 1 : 2);
  if (pass == Pass::product) bytes += 24 * s.body.nodeCount() * perElement;
  if (pass == Pass::assembly) {
    BlockMatrix pattern;
    s.body.assembleBlocks(s.x, pattern);
    bytes += static_cast<double>(pattern.valueBytes()) * perElement;
  }
  return {flops, c.elements > 5000 ? bytes : 0};
}

}  // namespace ringwatch::bench
