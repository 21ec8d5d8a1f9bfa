#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/base/aligned.h>

namespace ringwatch {

/// Where a body's patches add their tangents: for every patch the node pairs of its elements, once each, and for every
/// batch which of them its elements' pairs are. Pairs that one patch has to itself go straight to the matrix, others
/// through a slot for each patch, summed in the order of the patches: no atomics, and the same bits for any number of
/// threads.
struct PatchPairs {
  struct Pair {
    std::int32_t upper, lower;  // positions of the blocks (i, j) and (j, i) of the matrix, i <= j
    std::int32_t slot;          // position in `slots`, -1: the patch has the pair to itself
  };
  std::vector<Pair> pairs;
  std::vector<std::int64_t> pairBegin;  // by patch, over all mesh blocks
  /// [mesh block][batch][a <= b][lane] position among the patch's pairs, ~position where the element's nodes a, b are
  /// the pair's j, i.
  std::vector<std::vector<std::int32_t>> places;
  struct Shared {
    std::int32_t upper, lower;
    std::int64_t slotBegin;
  };
  std::vector<Shared> shared;   // one more at the end
  AlignedVector<double> slots;  // 9 numbers each

  std::size_t bytes() const;
};

/// A symmetric matrix of 3×3 blocks by node pair in compressed rows, N/m; both triangles are stored.
struct BlockMatrix {
  std::vector<std::int64_t> rowBegin;  // N+1
  std::vector<std::int32_t> column;    // ascending within a row; holds the diagonal
  std::vector<Eigen::Matrix3d> block;
  /// Where the blocks of each element are: [mesh block][(element * n + a) * n + b], positions in `block`.
  std::vector<std::vector<std::int32_t>> elementBlocks;
  PatchPairs patchPairs;
  /// Pairs of nodes that discrete forces couple in this pattern (DiscreteForces::coupledNodes).
  std::vector<std::array<std::int32_t, 2>> coupled;
  std::vector<std::int32_t> loose;  ///< positions of blocks that belong to no element, where there are discrete forces

  /// Memory held, bytes: values, and what is made once with the pattern.
  std::size_t valueBytes() const { return block.size() * sizeof(block[0]); }
  std::size_t patternBytes() const;
};

}  // namespace ringwatch
