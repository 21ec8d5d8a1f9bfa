#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {

/// How far points can have moved against those near them: diagonals of boxes that hold the displacements of all points
/// of a neighbourhood, a cell of a grid with the cells around it. Grids of twice the edge each, up to one whose
/// neighbourhoods hold all, do the same for points that are further apart. A neighbourhood that moves as a whole has
/// moved by nothing. Theorem 56, docs/theory/discrete_forces.md.
class RelativeMotion {
 public:
  /// Positions of points, a column each, whose last row is zero: a column fills a register.
  using Points = Eigen::Matrix4Xd;

  /// Of points at these positions, which are finite. edge: of the cells of the finest grid, m, > 0.
  void start(const Points& at, double edge);
  bool started() const { return !levels_.empty(); }
  void forget() { levels_.clear(); }
  double edge() const { return edge_; }

  /// The finest cell of a point.
  std::int32_t cellOf(std::size_t point) const { return cellOf_[point]; }
  /// All points moved to there. Neighbourhoods are asked only when points have moved some way against one another since
  /// they were last.
  void move(const Points& to, int threads);
  /// Paths of the neighbourhood of a cell, m: between a call of move and a later one the vector between two of its
  /// points changed by no more than pathTo at the later one less pathFrom at the earlier one.
  double pathTo(std::int32_t cell) const { return levels_.front().path[cell] + since_; }
  double pathFrom(std::int32_t cell) const { return levels_.front().path[cell] - since_; }
  double longestPath() const;

  /// Let two things of points be further apart at the start than `apart` or, where not all of their points are in one
  /// neighbourhood of the finest grid, than the edge less `extent`, which is the largest width of one of them. Whether
  /// they are still further apart than `needed`, all m, with the points at `now`, where they moved last.
  bool keepsApart(double apart, double extent, double needed, const Points& now, int threads);

 private:
  struct Box {
    Eigen::Array4d least, most;
    void clear();
    void add(const Box& other) {
      least = least.min(other.least);
      most = most.max(other.most);
    }
    double diagonal() const;
  };
  struct Level {
    CompressedRows<std::int32_t> members;  // a row a cell: points, above the finest level cells of the level below
    CompressedRows<std::int32_t> around;   // and the cells whose points are of its neighbourhood
    std::vector<double> path;              // m
    std::vector<double> moved;             // m: no less than the displacements' diagonal, less the path
  };
  /// Calls use(level, cell, diagonal) for the neighbourhoods of all cells.
  /// Adds what points moved since last_ to the paths.
  void askNeighbourhoods(const Points& now, int threads);
  template <class Use>
  void forDiagonals(const Points& from, const Points& to, int threads, const Use& use);

  Points start_, last_;  // last_: when neighbourhoods were last asked
  double since_ = 0;     // m: no less than the diagonal of all displacements since then
  double edge_ = 0;
  std::vector<std::int32_t> cellOf_;
  std::vector<Level> levels_;
  std::vector<Box> boxes_, above_;
};

}  // namespace ringwatch
