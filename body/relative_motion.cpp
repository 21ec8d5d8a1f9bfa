#include <ringwatch/body/relative_motion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/rounding.h>

namespace ringwatch {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// By which rounding makes a diagonal, or a sum of them, too short at most.
constexpr double up = 1 + 16 * unitRoundoff;
/// Along an axis, so that their numbers are numbers; points that are so far apart are those of a run that has exploded.
constexpr double mostCells = 1e12;
/// What all points may move by against one another until neighbourhoods are asked again, over the edge of the cells:
/// small against that for which things wait.
constexpr double unaskedOfEdge = 0.005;

/// Cells of things, which come in any order: numbers of the cells of all, and the cells, ascending.
struct Numbered {
  std::vector<std::int32_t> cellOf;
  std::vector<Cell> cells;
};
Numbered numberCells(const std::vector<Cell>& all) {
  Numbered result;
  result.cells = all;
  std::sort(result.cells.begin(), result.cells.end());
  result.cells.erase(std::unique(result.cells.begin(), result.cells.end()), result.cells.end());
  for (const Cell& cell : all)
    result.cellOf.push_back(static_cast<std::int32_t>(std::lower_bound(result.cells.begin(), result.cells.end(), cell) -
                                                      result.cells.begin()));
  return result;
}

CompressedRows<std::int32_t> membersOf(const Numbered& numbered) {
  CompressedRows<std::int32_t> rows;
  rows.offsets.assign(numbered.cells.size() + 1, 0);
  for (const std::int32_t cell : numbered.cellOf) ++rows.offsets[cell + 1];
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  rows.values.resize(numbered.cellOf.size());
  std::vector<std::size_t> at(rows.offsets.begin(), rows.offsets.end() - 1);
  for (std::size_t i = 0; i < numbered.cellOf.size(); ++i)
    rows.values[at[numbered.cellOf[i]]++] = static_cast<std::int32_t>(i);
  return rows;
}

CompressedRows<std::int32_t> aroundOf(const std::vector<Cell>& cells) {
  CompressedRows<std::int32_t> rows;
  for (const Cell& cell : cells) {
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        // Of one row of the grid, which follow one another.
        const Cell first{cell[0] + i, cell[1] + j, cell[2] - 1}, last{first[0], first[1], cell[2] + 1};
        for (auto found = std::lower_bound(cells.begin(), cells.end(), first); found != cells.end() && *found <= last;
             ++found)
          rows.values.push_back(static_cast<std::int32_t>(found - cells.begin()));
      }
    rows.offsets.push_back(rows.values.size());
  }
  return rows;
}

}  // namespace

void RelativeMotion::Box::clear() {
  least.setConstant(infinity);
  most.setConstant(-infinity);
}

/// At least the diagonal of the box of the exact displacements.
double RelativeMotion::Box::diagonal() const {
  return up * (most - least).matrix().norm() + 4 * unitRoundoff * (-least).max(most).maxCoeff();
}

void RelativeMotion::start(const Points& at, double edge) {
  start_ = last_ = at;
  since_ = 0;
  levels_.clear();
  const Eigen::Vector4d lowest = at.rowwise().minCoeff();
  const double width = (at.rowwise().maxCoeff() - lowest).maxCoeff();
  edge_ = std::max(edge, width / mostCells);
  std::vector<Cell> cells;
  for (Eigen::Index p = 0; p < at.cols(); ++p) {
    Cell& cell = cells.emplace_back();
    for (int i = 0; i < 3; ++i)
      cell[i] = std::isfinite(edge_) ? static_cast<std::int64_t>((at(i, p) - lowest[i]) / edge_) : 0;
  }
  for (bool whole = false; !whole;) {
    const Numbered numbered = numberCells(cells);
    if (levels_.empty()) cellOf_ = numbered.cellOf;
    Level& level = levels_.emplace_back();
    level.members = membersOf(numbered);
    level.around = aroundOf(numbered.cells);
    level.path.assign(numbered.cells.size(), 0);
    level.moved.assign(numbered.cells.size(), 0);
    whole = true;
    cells.clear();
    for (const Cell& cell : numbered.cells) {
      whole = whole && cell[0] <= 1 && cell[1] <= 1 && cell[2] <= 1;
      cells.push_back({cell[0] / 2, cell[1] / 2, cell[2] / 2});
    }
  }
}

template <class Use>
void RelativeMotion::forDiagonals(const Points& from, const Points& to, int threads, const Use& use) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    const std::size_t count = level.path.size();
    above_.resize(count);
    if (l == 0) {
      parallelFor(
          0, static_cast<std::int64_t>(count), threads,
          [&](std::int64_t cell) {
            Box box;
            box.clear();
            for (const std::int32_t point : level.members.row(cell)) {
              const Eigen::Array4d moved = to.col(point) - from.col(point);
              box.add({moved, moved});
            }
            above_[cell] = box;
          },
          64);
    } else {
      for (std::size_t cell = 0; cell < count; ++cell) {
        above_[cell].clear();
        for (const std::int32_t member : level.members.row(cell)) above_[cell].add(boxes_[member]);
      }
    }
    boxes_.swap(above_);
    for (std::size_t cell = 0; cell < count; ++cell) {
      Box box;
      box.clear();
      for (const std::int32_t other : level.around.row(cell)) box.add(boxes_[other]);
      use(level, cell, box.diagonal());
    }
  }
}

void RelativeMotion::askNeighbourhoods(const Points& now, int threads) {
  forDiagonals(last_, now, threads, [](Level& level, std::size_t cell, double diagonal) {
    level.path[cell] = up * (level.path[cell] + diagonal);
  });
  last_ = now;
  since_ = 0;
}

void RelativeMotion::move(const Points& to, int threads) {
  Box box;
  box.clear();
  for (Eigen::Index p = 0; p < to.cols(); ++p) {
    const Eigen::Array4d moved = to.col(p) - last_.col(p);
    box.add({moved, moved});
  }
  since_ = box.diagonal();
  if (!(since_ <= unaskedOfEdge * edge_)) askNeighbourhoods(to, threads);
}

double RelativeMotion::longestPath() const {
  double longest = 0;
  for (const double path : levels_.front().path) longest = std::max(longest, path);
  return longest + since_;
}

bool RelativeMotion::keepsApart(double apart, double extent, double needed, const Points& now, int threads) {
  const auto keeps = [&] {
    // How far things were apart of whose points this level is the first to have all in one neighbourhood.
    double least = apart, edge = edge_;
    for (const Level& level : levels_) {
      for (std::size_t cell = 0; cell < level.path.size(); ++cell)
        if (!(least - (level.moved[cell] + level.path[cell] + since_) >= needed)) return false;
      least = edge - extent;
      edge *= 2;
    }
    return true;
  };
  if (keeps()) return true;
  if (since_ > 0) askNeighbourhoods(now, threads);
  // The way there was longer than the displacement.
  forDiagonals(start_, now, threads, [](Level& level, std::size_t cell, double diagonal) {
    level.moved[cell] = std::min(level.moved[cell], diagonal - level.path[cell]);
  });
  return keeps();
}

}  // namespace ringwatch
