#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/body/relative_motion.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// The speed below which friction is viscous, so that surfaces stick: a speed, or in proportion to the depth. One of
/// the two is > 0 where there is friction.
struct SlipSpeed {
  double speed = 0;    ///< m/s
  double ofDepth = 0;  ///< 1/s
  double at(double depth) const { return speed > 0 ? speed : ofDepth * depth; }
  /// k depth/at(depth), N s/m, of the penalty k, N/m: friction's dashpot while surfaces stick, over μ.
  double dashpot(double penalty, double depth) const { return speed > 0 ? penalty * depth / speed : penalty / ofDepth; }
};

/// Throws InputError unless one of the two is > 0 where there is friction.
void requireSlip(double friction, const SlipSpeed& slip);

/// Nodes that the triangles of a surface push away, of other parts of the mesh and of the nodes' own one.
///
/// A node that is behind the surface, in its nearest triangle's solid, has the energy k d²/2, d its distance from that
/// triangle. So k r acts between the node and the closest point, r from the point to the node; on the corners it acts
/// by the point's barycentric weights w. Nearest is counted among triangles that share no element with the node and
/// that the surface at the node faces. A node deeper than `depth` of the triangle or its own `nodeDepth` is not held,
/// so that one that is outside of the solid is never taken for one that has come into it (Theorem 53). Viscous damping
/// and friction act on the velocity of the node against that of the point, as in PenaltyContact. Forces sum to zero;
/// friction's moment is not balanced, by the depth times the force.
///
/// Edges of the surface push each other away, too, where some are given: two that have gone through one another have
/// the same energy of their distance, and the force acts between their closest points, each on the two ends of its
/// edge.
struct SurfaceContact {
  std::vector<std::int32_t> nodes;  ///< of the surface, ascending
  std::vector<double> penalty;      ///< k of each node, N/m
  std::vector<double> damping;      ///< c of each node, N s/m
  /// θ of each node, > 0: its majorant has the share 1 + θ of k, those of the corners 1 + 1/θ times w together (Theorem
  /// 54, docs/theory/discrete_forces.md). Good is the mass of the node over that of the surface's.
  std::vector<double> split;
  double friction = 0;  ///< μ
  SlipSpeed slip;

  std::vector<std::array<std::int32_t, 3>> triangles;  ///< corners, counter-clockwise as seen from outside
  std::vector<double> depth;                           ///< m, of each triangle
  std::vector<double> nodeDepth;                       ///< m, of each node
  /// Triangles next to those, with a corner of theirs: a node that is nearest to one of them touches nothing.
  std::vector<std::array<std::int32_t, 3>> around;
  /// A row a node: pairs of corners behind one another, of the triangles of the surface at the node, which may be
  /// others.
  CompressedRows<std::array<std::int32_t, 2>> fan;
  /// A row a node: nodes that share an element with it, ascending.
  CompressedRows<std::int32_t> neighbours;

  /// An edge at which the surface turns outwards.
  struct Edge {
    std::array<std::int32_t, 2> nodes;
    /// Third corners of its triangles, which are nodes[0], nodes[1], third[0] and nodes[1], nodes[0], third[1],
    /// counter-clockwise as seen from outside.
    std::array<std::int32_t, 2> third;
    bool touches, touched;  ///< both of its ends are among `nodes`; it is of one of `triangles`
    double depth;           ///< m, to which it holds another one; of a pair the smaller
    double penalty = 0;     ///< N/m; of a pair the smaller
    double damping = 0;     ///< N s/m; of a pair the smaller
    /// kg, > 0. θ of a pair is the first one's over the second one's, within leastSplit and largestSplit.
    double mass = 1;
  };
  /// Each pair of one that touches and one that is touched counts once, unless they share or are next to an element.
  std::vector<Edge> edges;
  static constexpr double leastSplit = 0.1, largestSplit = 10;  ///< bounds of θ that scenes and pairs of edges keep
};

/// Of nodes of a mesh's surface and the triangles of its surface whose corners are all among `surface`, both ascending;
/// depth is half of the height of the element behind a triangle at rest, nodeDepth half of the least height at the
/// node, of such elements and of the triangles. Penalties and the rest are left empty, θ is 1. With an angle, radians,
/// edges at which the surface turns outwards by more than that at rest. Throws InputError for nodes that are not of the
/// surface, and where there is no triangle.
SurfaceContact surfaceContact(const Mesh& mesh, std::vector<std::int32_t> nodes,
                              const std::vector<std::int32_t>& surface, std::optional<double> edgeAngle = {});

/// Where the nodes of a SurfaceContact touch. It keeps what it found last, lists of the triangles that are near, of a
/// bounding-volume hierarchy, which serve until nodes have moved some way against those near them, and of each pair in
/// them how far it was apart, so that it is looked at again when it can count. What is found does not depend on any of
/// that: Theorems 56, 65 and 90, docs/theory/discrete_forces.md. One thread at a time.
class SurfaceSearch {
 public:
  /// Throws InputError for rows, penalties and dampings that are not one a node, and constants that are negative.
  SurfaceSearch(SurfaceContact contact, std::int32_t nodeCount);

  /// A node that touches a triangle, or two edges that touch. r = Σ b_c x_c over its four nodes; b = (1, -w), of edges
  /// (1 - s, s, t - 1, -t).
  struct Touch {
    std::int32_t entry;                 ///< position in SurfaceContact::nodes; of edges the first one's in edges
    std::int32_t triangle;              ///< position in SurfaceContact::triangles, -1 for edges
    std::int32_t otherEdge;             ///< the second one's position in SurfaceContact::edges, -1 for a triangle
    std::array<std::int32_t, 4> nodes;  ///< the node and the triangle's corners; the ends of both edges
    std::array<double, 4> b;
    double penalty, damping;  ///< N/m, N s/m
    Eigen::Vector3d r;        ///< m, from the closest point to the node; of edges from the second to the first
    Eigen::Vector3d normal;   ///< out of the surface, a unit vector along -r
    double depth;             ///< m, |r|
    /// Directions T in which the closest point is free to move: two in a face, one on an edge, none at a corner; of
    /// edges one along each. T[j] is from the node base[j] to the node to[j] of the four. inverse: of Tᵀ T.
    int free;
    std::array<int, 2> base, to;
    std::array<Eigen::Vector3d, 2> T;
    Eigen::Matrix2d inverse;

    /// Tᵢ b_c + e_ci r, e_ci the derivative of T at corner c: what the tangent lacks of k b bᵀ.
    Eigen::Vector3d column(int c, int i) const {
      Eigen::Vector3d own = b[c] * T[i];
      if (c == to[i]) own += r;
      if (c == base[i]) own -= r;
      return own;
    }
    /// Of base and to.
    void setDirections(NodeVectorsView x, int directions);
    /// ∂²(k d²/2)/∂x_a∂x_c + f c b_a b_c n nᵀ, N/m, for fc = f c. Theorem 53, docs/theory/discrete_forces.md.
    Eigen::Matrix3d block(int a, int c, double k, double fc) const;
  };
  /// A node and a triangle that can touch before nodes have moved by the reach against one another, and the largest
  /// weights of the corners with which they can.
  struct Near {
    std::int32_t entry, triangle;
    double depth;  ///< m, now; 0 in front
    std::array<double, 3> weight;
  };

  /// Two edges that can touch, and the largest shares of their ends in their closest points with which they can.
  struct NearEdges {
    std::array<std::int32_t, 2> edges;  ///< positions in SurfaceContact::edges
    double penalty, damping;            ///< N/m, N s/m
    double split;                       ///< θ
    double depth;                       ///< m, now; 0 in front
    std::array<double, 4> weight;
  };

  const SurfaceContact& contact() const { return contact_; }
  /// Nodes and corners, ascending.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  /// Looks where nodes touch at x, 3×N, and which can within a reach, m >= 0; nothing is done where that is known. None
  /// do at positions that are not finite.
  void locate(NodeVectorsView x, double reach, int threads);
  /// Of the last look; nodes before edges, by entry, near() by triangle within.
  const std::vector<Touch>& touching() const { return touching_; }
  const std::vector<Near>& near() const { return near_; }
  const std::vector<NearEdges>& nearEdges() const { return nearEdges_; }
  /// Where nodes()[i] was then, m.
  Eigen::Vector3d positionOf(std::size_t i) const { return at_.col(static_cast<Eigen::Index>(i)).head<3>(); }
  bool located() const { return located_; }

  /// Searches of the hierarchy so far, looks, and closest points of pairs of a node and a triangle, and of edges.
  struct Statistics {
    std::int64_t lists = 0, looks = 0, pairs = 0, edgePairs = 0;
  };
  const Statistics& statistics() const { return statistics_; }

 private:
  /// The closest point of a triangle.
  struct Closest {
    double distance2;
    std::array<double, 3> w;
    Eigen::Vector3d r;       // to the node
    int free;                // 2: in the face, 1: on the edge from the corner to the next, 0: at the corner
    int corner;              // of free < 2
    Eigen::Vector3d normal;  // of the triangle, not of unit length
  };
  static Closest closestPoint(const Eigen::Vector3d& s, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c);
  /// The closest points of two edges, at the shares s and t.
  struct ClosestOfEdges {
    double distance2;
    double s, t;
    Eigen::Vector3d r;      // from the second to the first
    Eigen::Vector3d cross;  // of the edges
    bool inside;            // of both edges, and these are not parallel
  };
  static ClosestOfEdges closestPoints(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                      const Eigen::Vector3d& d);
  void makeLists(NodeVectorsView x, double reach, int threads);
  void makeEdgeLists(NodeVectorsView x, int threads);
  bool listsServe(double reach, int threads);
  /// What rows of the lists find.
  struct Found {
    std::vector<Touch> touching;
    std::vector<Near> near;
    std::vector<NearEdges> nearEdges;
    std::int64_t pairs = 0;
  };
  void lookAtEdges(NodeVectorsView x, std::size_t row, double reach, Found& found);
  void addEdges(NodeVectorsView x, std::int32_t edge, std::int32_t other, const ClosestOfEdges& closest, double reach,
                Found& found) const;
  std::array<Eigen::Vector3d, 2> normalsAt(NodeVectorsView x, const SurfaceContact::Edge& edge) const;
  void look(NodeVectorsView x, std::size_t row, double reach, Found& found);
  void addTouch(NodeVectorsView x, std::int32_t entry, std::int32_t triangle, const Closest& closest,
                std::vector<Touch>& touching) const;
  const std::array<std::int32_t, 3>& cornersOf(std::int32_t triangle) const {
    const auto touched = static_cast<std::int32_t>(contact_.triangles.size());
    return triangle < touched ? contact_.triangles[triangle] : contact_.around[triangle - touched];
  }
  bool behind(NodeVectorsView x, const Eigen::Vector3d& s, std::int32_t triangle, const Closest& closest) const;
  /// Unit normals of the surface at a node: of all of it, and of each triangle.
  void normalsAt(NodeVectorsView x, std::int32_t entry, std::vector<Eigen::Vector3d>& normals) const;

  SurfaceContact contact_;
  std::vector<std::int32_t> nodes_;
  // Triangles are numbered on from contact_.triangles to contact_.around.
  std::vector<std::int32_t> cornerPlace_;            // by node: its row of trianglesAt_, -1
  CompressedRows<std::int32_t> trianglesAt_;         // a row a corner
  double deepest_ = 0, deepestEdge_ = 0, skin_ = 0;  // m

  // Lists of triangles within listed_ of nodes when motion_ was started, which count below listed_ - rounding_.
  std::vector<std::int32_t> rows_;  // entries that have any
  CompressedRows<std::int32_t> candidates_;
  RelativeMotion motion_;  // of nodes()
  double listed_ = 0, extent_ = 0, rounding_ = 0;
  // By candidate: its distance plus the path of its node's cell when it was looked at; by row: the least, the cell, and
  // the candidate that was nearest, -1.
  std::vector<double> until_, rowUntil_;
  std::vector<std::int32_t> rowCell_, rowNearest_;
  // The same of edges, by row those that touch and their candidates, which are touched.
  std::vector<std::int32_t> edgeRows_;
  CompressedRows<std::int32_t> edgeCandidates_;
  double edgeListed_ = 0, edgeExtent_ = 0;
  std::vector<double> edgeUntil_, edgeRowUntil_;
  std::vector<std::int32_t> edgeRowCell_;

  RelativeMotion::Points at_;  // of nodes()
  double reach_ = -1;
  bool located_ = false;
  std::vector<Touch> touching_;
  std::vector<Near> near_;
  std::vector<NearEdges> nearEdges_;
  Statistics statistics_;
};

}  // namespace ringwatch
