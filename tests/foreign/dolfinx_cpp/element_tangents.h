#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <dolfinx/fem/assembler.h>

/// The tangents of a form's elements for ringwatch::TangentBracket: assembly hands them over one by one.
struct ElementTangents {
  std::vector<std::int32_t> nodes;  // element after element
  std::vector<double> values;       // 3n x 3n numbers each, N/m

  void assemble(const dolfinx::fem::Form<double>& tangent) {
    nodes.clear();
    values.clear();
    const auto take = [this](std::span<const std::int32_t> rows, std::span<const std::int32_t>,
                             std::span<const double> K) {
      nodes.insert(nodes.end(), rows.begin(), rows.end());
      values.insert(values.end(), K.begin(), K.end());
      return 0;
    };
    dolfinx::fem::assemble_matrix(take, tangent, {});
  }
};
