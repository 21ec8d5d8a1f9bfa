#pragma once
#include <vector>

#include <ringwatch/meshes/mesh.h>
#include <ringwatch/meshes/modify/bisection.h>

namespace ringwatch {

/// A surface to cut along: an endless plane, or a polyline swept along a vector.
class CutSurface {
 public:
  /// Throws InputError for a normal of length zero and for numbers that are not finite.
  static CutSurface plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);
  /// The points line(s) + u sweep, 0 <= u <= 1, m: it ends where line and sweep end. Throws InputError for fewer than
  /// two points, points that coincide, a piece of the line along the sweep, and numbers that are not finite.
  static CutSurface swept(std::vector<Eigen::Vector3d> line, const Eigen::Vector3d& sweep);

  /// Distance of a point, m, with the sign of its side; of a swept line the nearest piece counts, its first and last
  /// ones going on without end.
  double distance(const Eigen::Vector3d& x) const;
  /// Whether a point on the surface is within its ends.
  bool reaches(const Eigen::Vector3d& x) const;

 private:
  struct Nearest {
    double distance;
    bool beyondEnds;
  };
  Nearest nearest(const Eigen::Vector3d& x) const;

  Eigen::Vector3d point_, normal_;      // of a plane
  std::vector<Eigen::Vector2d> line_;   // of a swept line, in the plane across the sweep; empty for a plane
  Eigen::Matrix<double, 2, 3> across_;  // onto that plane
  Eigen::Vector3d start_, along_;       // along_ · (x - start_) is u
};

/// A mesh after a cut.
struct CutMesh {
  Mesh mesh;
  /// Where each node comes from: an old one (a = b, t = 0) or a point on the edge between two. Fields that are linear
  /// in the elements are carried over without error.
  std::vector<EdgePoint> origin;
  std::vector<std::vector<std::int32_t>> parent;  // [block][element]: the element before
  /// Elements with a node around which something has changed, mass or stiffness: a node of a cut element, or a doubled
  /// one.
  std::vector<std::vector<bool>> changed;
  std::size_t elementsCut = 0, nodesAdded = 0, facesOpened = 0;
  double area = 0;  // of the opened faces at rest, m², one side
};

/// Cuts a mesh of tetrahedra along a surface by element subdivision: edges that cross it get a node there
/// (`bisectEdges`), and faces that lie in it are opened by doubling their nodes but those at its rim. A node nearer to
/// the surface than `snap` of a crossing edge's length is taken as on it instead, as if the surface bent to meet it:
/// that saves slivers and moves nothing. 0 cuts exactly; then nodes within a millionth count as on the surface. Volume
/// is kept, and with row-sum lumping mass and linear momentum of fields that are carried over. x: positions (3×N, m) at
/// which it cuts, the reference positions or deformed ones. A surface that opens no face leaves the mesh as it is, with
/// facesOpened = 0. Throws InputError for elements other than tet4, and unless 0 <= snap <= 0.5.
CutMesh cutMesh(const Mesh& mesh, const CutSurface& surface, const NodeVectors& x, double snap = 0.1);

/// A nodal field (3×N) carried over to the nodes after a cut.
NodeVectors carriedOver(const CutMesh& cut, const NodeVectors& field);

}  // namespace ringwatch
