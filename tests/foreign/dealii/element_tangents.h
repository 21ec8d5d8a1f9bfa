#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include <deal.II/fe/fe.h>
#include <deal.II/lac/full_matrix.h>

/// The tangents of cells of linear elements for ringwatch::TangentBracket, pushed where a program of deal.II's
/// tutorials distributes its cell_matrix. Nodes are vertices.
struct ElementTangents {
  std::vector<std::int32_t> nodes;  // element after element
  std::vector<double> values;       // 3n x 3n numbers each, N/m

  template <class Cell>
  void push(const Cell& cell, const dealii::FullMatrix<double>& cell_matrix) {
    const auto& fe = cell->get_fe();
    for (const unsigned int v : cell->vertex_indices())
      nodes.push_back(static_cast<std::int32_t>(cell->vertex_index(v)));
    const auto place = [&fe](unsigned int i) {
      const auto [component, vertex] = fe.system_to_component_index(i);
      return 3 * vertex + component;
    };
    const std::size_t size = fe.n_dofs_per_cell(), first = values.size();
    values.resize(first + size * size);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < size; ++j) values[first + place(i) * size + place(j)] = cell_matrix(i, j);
  }
};
