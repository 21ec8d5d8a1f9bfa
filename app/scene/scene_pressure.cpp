#include <ringwatch/app/scene/scene_pressure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {
namespace {

/// On [0, 1]² mapped to the face: bilinear between the four corners; a triangle's last two corners are one, so that s
/// runs from its first edge to that corner. Where shape functions have degree d in each direction, N x_r × x_s has 3d -
/// 1 at most, and so has a triangle's with the factor that vanishes at its corner: d + 1 Gauss points are exact up to
/// 2d + 1.
FaceQuadrature faceQuadrature(const ElementInfo& element, const std::array<int, 4>& corners) {
  using Vector = Eigen::Vector3d;
  const auto corner = [&](std::size_t k) {
    const auto& at = element.referenceNodes[static_cast<std::size_t>(corners[k] < 0 ? corners[k - 1] : corners[k])];
    return Vector(at[0], at[1], at[2]);
  };
  const std::array<Vector, 4> at{corner(0), corner(1), corner(2), corner(3)};
  const std::span<const double> x =
      element.order == 1 ? std::span<const double>(gauss::x2) : std::span<const double>(gauss::x3);
  const std::span<const double> w =
      element.order == 1 ? std::span<const double>(gauss::w2) : std::span<const double>(gauss::w3);
  const auto count = static_cast<std::size_t>(element.nodes);

  FaceQuadrature made;
  std::vector<double> N(count), largest(count, 0.0);
  std::vector<std::array<double, 3>> dN(count);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) {
      const double r = 0.5 * (1 + x[i]), s = 0.5 * (1 + x[j]);
      const Vector xi = (1 - r) * (1 - s) * at[0] + r * (1 - s) * at[1] + r * s * at[2] + (1 - r) * s * at[3];
      const Vector xiR = (1 - s) * (at[1] - at[0]) + s * (at[2] - at[3]);
      const Vector xiS = (1 - r) * (at[3] - at[0]) + r * (at[2] - at[1]);
      element.shape(xi.data(), N.data());
      element.shapeGradient(xi.data(), reinterpret_cast<double(*)[3]>(dN.data()));
      FaceQuadrature::Point& point = made.points.emplace_back(FaceQuadrature::Point{0.25 * w[i] * w[j], N, {}, {}});
      for (std::size_t a = 0; a < count; ++a) {
        const Vector gradient(dN[a][0], dN[a][1], dN[a][2]);
        point.dr.push_back(gradient.dot(xiR));
        point.ds.push_back(gradient.dot(xiS));
        largest[a] = std::max(largest[a], std::abs(N[a]));
      }
    }
  // Shape functions of all other nodes vanish on a face, and so do their derivatives along it.
  constexpr double vanishes = 1e-12;
  for (std::size_t a = 0; a < count; ++a)
    if (largest[a] > vanishes) made.nodes.push_back(static_cast<int>(a));
  for (FaceQuadrature::Point& point : made.points)
    for (std::vector<double>* all : {&point.N, &point.dr, &point.ds}) {
      std::vector<double> own;
      for (const int a : made.nodes) own.push_back((*all)[static_cast<std::size_t>(a)]);
      *all = std::move(own);
    }
  return made;
}

}  // namespace

std::vector<PressedFace> pressedFaces(const Scene::Pressure& pressure, const Mesh& mesh) {
  std::vector<bool> selected(mesh.nodeCount(), false);
  for (const std::int32_t node : pressure.nodes.nodesOf(mesh)) selected[node] = true;
  std::map<std::pair<ElementType, int>, std::shared_ptr<const FaceQuadrature>> rules;
  std::vector<PressedFace> faces;
  for (const ElementFace& face : boundaryFaces(mesh)) {
    const MeshBlock& block = mesh.blocks[face.block];
    const ElementInfo& info = elementInfo(block.type);
    const auto nodes = block.element(face.element);
    const std::array<int, 4>& corners = info.faces[face.face];
    if (!std::ranges::all_of(corners, [&](int corner) { return corner < 0 || selected[nodes[corner]]; })) continue;
    auto& rule = rules[{block.type, static_cast<int>(face.face)}];
    if (!rule) rule = std::make_shared<const FaceQuadrature>(faceQuadrature(info, corners));
    PressedFace& made = faces.emplace_back(PressedFace{{}, rule});
    for (const int a : rule->nodes) made.nodes.push_back(nodes[a]);
  }
  if (faces.empty())
    throw InputError(fmt::format("{}: no face of the surface has all of its corners among the selected nodes; widen it",
                                 pressure.nodes.origin));
  return faces;
}

void addPressure(const PressedFace& face, double pressure, NodeVectorsView x,
                 const std::function<void(std::int32_t node, const Eigen::Vector3d& force)>& add) {
  constexpr int mostNodes = 9;  // of a quadrilateral of second order
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, mostNodes> forces =
      Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, mostNodes>::Zero(3, static_cast<Eigen::Index>(face.nodes.size()));
  for (const FaceQuadrature::Point& point : face.quadrature->points) {
    Eigen::Vector3d xr(0, 0, 0), xs(0, 0, 0);
    for (std::size_t a = 0; a < face.nodes.size(); ++a) {
      xr += point.dr[a] * x.col(face.nodes[a]);
      xs += point.ds[a] * x.col(face.nodes[a]);
    }
    const Eigen::Vector3d push = -pressure * point.weight * xr.cross(xs);
    for (std::size_t a = 0; a < face.nodes.size(); ++a) forces.col(static_cast<Eigen::Index>(a)) += point.N[a] * push;
  }
  for (std::size_t a = 0; a < face.nodes.size(); ++a) add(face.nodes[a], forces.col(static_cast<Eigen::Index>(a)));
}

}  // namespace ringwatch
