#include <ringwatch/app/scene/scene_state.h>

#include <Eigen/Geometry>

namespace ringwatch {

State sceneInitialState(const Scene& scene, const BodySystem& system) {
  State state = system.initialState();
  for (const Scene::Initial& initial : scene.initials)
    for (const std::int32_t node : initial.nodes.nodesOf(system.body().mesh())) {
      const Eigen::Vector3d arm = state.x.col(node) - initial.point;
      state.v.col(node) += initial.velocity + initial.angularVelocity.cross(arm);
    }
  system.body().constraints().imposeVelocity(state.v);
  return state;
}

}  // namespace ringwatch
