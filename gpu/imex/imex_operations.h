#pragma once
#include <cstdint>

#include <ringwatch/gpu/body/patch_operations.h>

namespace ringwatch {

/// Nodes of implicit clusters are numbered cluster by cluster in slices of ten, one warp each: lane 3 i + c holds
/// component c of the slice's node i, and two lanes are idle. Vectors over them have a number for each lane; a node is
/// called by the place of its first.
inline constexpr int sliceNodes = 10;

/// Elements of one mesh block that are integrated implicitly.
struct ImexElementsView {
  std::int32_t count = 0, pairCount = 0;  // pairs of an element's nodes
  const std::int32_t* place = nullptr;    // [element] [patch][thread] in the body's block
  const std::int32_t* node = nullptr;     // [a][element] first lane of node a
  const double* shape = nullptr;          // [3 a + j][element] fitted gradients: F = I + Σ u_a shape_a
  double* rest = nullptr;                 // [9 pair + entry][element] K_e(X), N/m, of node pairs a >= b
  double* restHighest = nullptr;          // [element] its highest eigenvalue
  double* rotation = nullptr;             // [10][element] R_e, row by row, and w s_e
  double* rotated = nullptr;              // [pair][element][9] w s_e R_e K_e(X) R_eᵀ
  const std::int32_t* cluster = nullptr;  // [element]
};

/// One element's part of a block of the matrix: a block of `rotated`, or, negative, ~block transposed.
using ImexContribution = std::int32_t;

/// The matrices M + w K̂ of all clusters in rows of blocks. Rows of a slice are as long as its longest.
struct ImexMatrixView {
  double* value = nullptr;                 // [row of slice][component j][32 lanes]: lane 3 i + c has entry (c, j)
  double* preconditioner = nullptr;        // [slice][component j][32 lanes] inverse diagonal blocks
  const std::int32_t* column = nullptr;    // [row of slice][10] first lane of the column's node
  const std::int32_t* rowBegin = nullptr;  // [slice], one more at the end
  const std::int32_t* slice = nullptr;     // [row of slice]
  const std::int32_t* first = nullptr;     // [row of slice][10] the block's contributions, one more at the end
  const ImexContribution* contributions = nullptr;
  const double* rotated = nullptr;  // of all mesh blocks
};

struct ImexCluster {
  std::int32_t firstSlice, sliceCount;
  bool held;  // has constrained components
};
/// Thread blocks that solve one large cluster together.
struct ImexTeam {
  std::int32_t cluster, firstBlock, blockCount;
};

/// Which steps failed, so that the first of them is known: bits of step, kind and cluster; all bits set: none.
enum class ImexFault : unsigned { notConverged = 0, notFinite = 1 };
struct ImexStatus {
  unsigned long long fault;
  unsigned long long iterations;  // of conjugate gradients, of all clusters
  std::int64_t step;              // that is being taken
};
RINGWATCH_INLINE unsigned long long imexFaultKey(std::int64_t step, ImexFault fault, std::int32_t cluster) {
  return static_cast<unsigned long long>(step) << 32 | static_cast<unsigned long long>(fault) << 31 |
         static_cast<unsigned long long>(cluster);
}

struct ImexView {
  double w = 0, h = 0, c = 0;  // s², s, 1/s; see Imex
  double tolerance = 0;
  int iterations = 0;
  std::int32_t sliceCount = 0, rowCount = 0;
  const std::int32_t* node = nullptr;  // [slice][10] device node, -1: none
  const double* mass = nullptr;        // [lane] kg
  double *u = nullptr, *v = nullptr;   // [lane] displacements and velocities before the step
  double *r = nullptr, *z = nullptr, *p = nullptr, *q = nullptr, *s = nullptr, *solution = nullptr;
  ImexMatrixView matrix;
  const ImexCluster* clusters = nullptr;
  // Who solves what: thread blocks of teams first; the others take clusters a thread block each, then a warp each.
  std::int32_t blockCount = 0, teamBlocks = 0;
  const std::int32_t* teamOfBlock = nullptr;  // [thread block < teamBlocks]
  const ImexTeam* teams = nullptr;
  const std::int32_t* ofBlocks = nullptr;
  const std::int32_t* ofWarps = nullptr;
  std::int32_t ofBlocksCount = 0, ofWarpsCount = 0;
  unsigned long long* arrived = nullptr;  // [team]
  double* partial = nullptr;              // [thread block][2][2]
  ImexStatus* status = nullptr;
};

inline constexpr int imexThreads = 256;
/// Thread blocks of the solver that the device holds at once.
int imexResidentBlocks();

/// Keeps the clusters' displacements and velocities as they are.
void launchKeepNodes(const ImexView& view, const NodeView<double>& nodes, cudaStream_t stream);
/// w s_e R_e K_e(X) R_eᵀ of a block's elements, block by block.
void launchRotateBlocks(const ImexElementsView& elements, cudaStream_t stream);
/// The matrices, from rotated and scaled rest tangents, with their preconditioners.
void launchAssembleClusters(const ImexView& view, const NodeView<double>& nodes, cudaStream_t stream);
/// Takes back the step of the clusters' nodes, which was explicit, and makes it implicit: all clusters in one launch.
void launchSolveClusters(const ImexView& view, const NodeView<double>& nodes, cudaStream_t stream);

}  // namespace ringwatch
