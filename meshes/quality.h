#pragma once
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/base/name_table.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Smallest and largest Jacobian determinant ∂X/∂ξ of an element, m³.
struct JacobianRange {
  double min = 0, max = 0;
};

/// Where a JacobianProbe looks. fine: also halfway between any two nodes, and halfway between any two of all these: in
/// a hexahedron at five places along each axis. The determinant may change its sign between the others: that of a
/// hexahedron whose top is numbered half a turn on is 0 in the middle alone.
enum class JacobianPoints { usual, fine };

/// Evaluates the Jacobian determinant of elements of one type at their quadrature points (default rule) and, for
/// elements whose gradient varies, at their corners and in the middle. A corner where the reference map itself is
/// singular (the apex of a pyramid) is left out.
class JacobianProbe {
 public:
  explicit JacobianProbe(const ElementInfo& info, JacobianPoints where = JacobianPoints::usual);
  /// x: 3×N positions, nodes: indices of the element's nodes. NaN positions give NaN.
  JacobianRange range(const NodeVectors& x, const std::int32_t* nodes) const;
  /// Σ w det J over the default rule: the signed volume, m³.
  double volume(const NodeVectors& x, const std::int32_t* nodes) const;
  /// Smallest of det J / (|J₁||J₂||J₃|) over the points, J_k the columns of J: 1 for a brick (Knupp's scaled Jacobian
  /// at the corners of a hexahedron).
  double minScaledJacobian(const NodeVectors& x, const std::int32_t* nodes) const;

 private:
  struct Point {
    std::vector<double> gradient;  // 3 a node
    double weight;                 // 0 of none of the rule
  };
  Eigen::Matrix3d jacobian(const Point& point, const NodeVectors& x, const std::int32_t* nodes) const;
  std::vector<Point> points_;
  int nodes_;
};

/// Shape measures of one element. NaN where a measure does not apply to the element.
struct ElementQuality {
  double volume = 0;     // signed, by the element's default rule, m³
  double minHeight = 0;  // m. Tetrahedra: 3V/A_max, exact. Others: V/A_max; the extent H over the largest face lies
                         // between V/A_max and 3V/A_max, so this is its safe end, and exact for bricks
  double minEdge = 0, maxEdge = 0;  // m
  double minScaledJacobian = 0;     // at quadrature points and corners; tetrahedra: √2·6V / max over the corners of
                                    // the product of the three edges there (1: regular); others: `JacobianProbe`
  double minDihedral = std::numeric_limits<double>::quiet_NaN();  // tetrahedra only, degrees
  double maxDihedral = std::numeric_limits<double>::quiet_NaN();
  double radiusRatio = std::numeric_limits<double>::quiet_NaN();  // tetrahedra only: 3 r_in / R_circ, 1: regular
};

/// The measures of element e of a block at positions x (3×N, m).
ElementQuality elementQuality(const MeshBlock& block, std::size_t e, const NodeVectors& x);

/// Shapes of tetrahedra (Bern et al. 1995, as in fig. 4.1 of Fierz 2013). Round: the width (least of all heights and
/// distances of opposite edges) is at least a fifth of the longest edge (regular: 0.71, Kuhn's: 0.24). Else what lies
/// closest in it names it:
/// two nodes, and they alone: wedge; more than two: needle; a node and the inside of the opposite face: cap; two
/// opposite edges that cross: sliver, or spindle when one of them is less than half as long as the other.
enum class ShapeClass {
  round,
  small,  // round, but with less than an eighth of the mesh's mean element volume
  needle,
  wedge,
  spindle,
  sliver,
  cap,
  other  // no tetrahedron: see its angles and its aspect
};
inline constexpr auto shapeNames = nameTable<ShapeClass>({
    {ShapeClass::round, "round"},
    {ShapeClass::small, "small"},
    {ShapeClass::needle, "needle"},
    {ShapeClass::wedge, "wedge"},
    {ShapeClass::spindle, "spindle"},
    {ShapeClass::sliver, "sliver"},
    {ShapeClass::cap, "cap"},
    {ShapeClass::other, "other"},
});
constexpr std::string_view shapeName(ShapeClass shape) { return shapeNames.nameOf(shape); }

struct ElementShape {
  ShapeClass shape = ShapeClass::other;
  double minDihedral = 0, maxDihedral = 0;  // between faces at their common edge, degrees; faces by their mean normal
  double aspect = 0;                        // longest over shortest edge

  /// "needle, 0.4° dihedral", "sliver, 2.1° dihedral", "small", "round", "dihedral angles 45° to 135°, aspect 3".
  std::string text() const;
};
/// The shape of element e of a block at positions x (3×N, m); meanVolume: of the mesh's elements, m³, 0 for unknown.
ElementShape elementShape(const MeshBlock& block, std::size_t e, const NodeVectors& x, double meanVolume);

/// The measures of every element: [block][element].
std::vector<std::vector<ElementQuality>> meshQuality(const Mesh& mesh);
std::vector<std::vector<ElementQuality>> meshQuality(const Mesh& mesh, const NodeVectors& x);

/// Smallest, largest and mean value of a measure, and where the extremes are. count = 0: no element has this measure.
struct QualitySummary {
  std::string name, unit;
  std::size_t count = 0;
  double min = 0, max = 0, mean = 0;
  ElementRef minElement, maxElement;
};

struct QualityMeasure {
  const char* name;
  const char* unit;
  double ElementQuality::*member;
};
/// All measures, in the order of `ElementQuality`.
std::span<const QualityMeasure> qualityMeasures();

/// A summary of every measure that at least one element has, in the order of `ElementQuality`.
std::vector<QualitySummary> summarizeQuality(const std::vector<std::vector<ElementQuality>>& quality);

/// Sum of the signed volumes, m³.
double meshVolume(const Mesh& mesh);

}  // namespace ringwatch
