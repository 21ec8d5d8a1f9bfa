#include <ringwatch/app/scene/scene_pressure.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {

std::vector<FaceNodes> pressedFaces(const Scene::Pressure& pressure, const Mesh& mesh) {
  std::vector<bool> selected(mesh.nodeCount(), false);
  for (const std::int32_t node : pressure.nodes.nodesOf(mesh)) selected[node] = true;
  std::vector<FaceNodes> faces;
  for (const ElementFace& face : boundaryFaces(mesh)) {
    const MeshBlock& block = mesh.blocks[face.block];
    const ElementInfo& info = elementInfo(block.type);
    FaceNodes nodes;
    bool all = true;
    for (std::size_t k = 0; k < 4; ++k) {
      const int corner = info.faces[face.face][k];
      nodes[k] = corner < 0 ? -1 : block.element(face.element)[corner];
      all = all && (corner < 0 || selected[nodes[k]]);
    }
    if (!all) continue;
    if (info.order > 1)
      throw InputError(
          fmt::format("{}: pressure is of faces of linear elements; the mesh has {}", pressure.origin, info.name));
    faces.push_back(nodes);
  }
  if (faces.empty())
    throw InputError(fmt::format("{}: no face of the surface has all of its corners among the selected nodes; widen it",
                                 pressure.nodes.origin));
  return faces;
}

void addPressure(const FaceNodes& face, double pressure, NodeVectorsView x,
                 const std::function<void(std::int32_t node, const Eigen::Vector3d& force)>& add) {
  const auto at = [&](int k) -> Eigen::Vector3d { return x.col(face[k]); };
  if (face[3] < 0) {
    const Eigen::Vector3d force = -pressure / 6 * (at(1) - at(0)).cross(at(2) - at(0));
    for (int k = 0; k < 3; ++k) add(face[k], force);
    return;
  }
  // n dA = x_r × x_s dr ds on [-1, 1]²; a bilinear normal times a bilinear N needs two points a direction.
  const double g = 1 / std::sqrt(3.0);
  static constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Eigen::Matrix<double, 3, 4> forces = Eigen::Matrix<double, 3, 4>::Zero();
  for (const double r : {-g, g})
    for (const double s : {-g, g}) {
      Eigen::Vector3d xr(0, 0, 0), xs(0, 0, 0);
      for (int k = 0; k < 4; ++k) {
        xr += 0.25 * corner[k][0] * (1 + corner[k][1] * s) * at(k);
        xs += 0.25 * corner[k][1] * (1 + corner[k][0] * r) * at(k);
      }
      const Eigen::Vector3d normal = xr.cross(xs);
      for (int k = 0; k < 4; ++k)
        forces.col(k) -= pressure * 0.25 * (1 + corner[k][0] * r) * (1 + corner[k][1] * s) * normal;
    }
  for (int k = 0; k < 4; ++k) add(face[k], forces.col(k));
}

}  // namespace ringwatch
