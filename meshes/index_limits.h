#pragma once
#include <cstdint>
#include <limits>

#include <ringwatch/base/error.h>

namespace ringwatch {

/// Nodes and elements have numbers of 32 bits.
inline constexpr std::int64_t elementCountLimit = std::numeric_limits<std::int32_t>::max();
/// And so have degrees of freedom, 3 · node + component.
inline constexpr std::int64_t nodeCountLimit = (elementCountLimit - 2) / 3;

/// Throws InputError where a sparse matrix of `nodes` nodes and 3×3 blocks has more entries than Eigen's 32-bit numbers
/// count.
inline void requireSparse(std::int64_t nodes, std::int64_t blocks) {
  constexpr std::int64_t entriesOfBlock = 9, most = std::numeric_limits<std::int32_t>::max() / entriesOfBlock;
  if (blocks > most)
    throw InputError(joinText("the matrix of ", nodes, " nodes has ", blocks, " blocks of 3x3 entries; at most ", most,
                              " are possible"));
}

}  // namespace ringwatch
