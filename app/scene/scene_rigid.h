#pragma once
#include <array>
#include <optional>
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_tables.h>

namespace ringwatch {

/// How a [[fix]] or [[move]] takes the rigid body that it names, and the nodes of that; empty where it names none.
/// Throws InputError for a body that there is not or that another section takes, and for keys that do not fit.
std::optional<Scene::Guide> guideOf(const SceneTable& section, const std::array<bool, 3>& components,
                                    const Scene& scene, NodeSelection& nodes);
/// Lets a [[fix]] or [[move]] take the rigid body that it names, if any.
template <class Item>
void takeRigidBody(const SceneTable& table, const Scene& scene, Item& item) {
  item.guide = guideOf(table, item.components, scene, item.nodes);
}
/// Splits the blocks of a mesh so that elements within one rigid body of the scene are in blocks of their own; element
/// sets follow. materials: of the blocks, or one of all; they follow too. Nothing changes without rigid bodies. Throws
/// InputError where nothing else is left.
void splitRigidBlocks(const Scene& scene, Mesh& mesh, std::vector<Material>& materials);
/// Ties the nodes of a body, whose motions are prescribed already but for those of rigid bodies with some freedom, to
/// the scene's rigid bodies. Throws InputError for selections without nodes, for nodes with a prescribed motion or in
/// two rigid bodies, and as RigidBody does.
void tieRigidBodies(const Scene& scene, Body& body);

}  // namespace ringwatch
