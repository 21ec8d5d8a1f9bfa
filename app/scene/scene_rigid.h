#pragma once
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_tables.h>

namespace ringwatch {

/// Reads the [[rigid]] of a scene, after all that they do not go with. Throws InputError.
void readRigidSections(const std::vector<SceneTable>& sections, Scene& scene);
/// Splits the blocks of a mesh so that elements within one rigid body of the scene are in blocks of their own; element
/// sets follow. materials: of the blocks, or one of all; they follow too. Nothing changes without rigid bodies. Throws
/// InputError where nothing else is left.
void splitRigidBlocks(const Scene& scene, Mesh& mesh, std::vector<Material>& materials);
/// Ties the nodes of a body, whose motions are prescribed already, to the scene's rigid bodies. Throws InputError for
/// selections without nodes, for nodes with a prescribed motion or in two rigid bodies, and as RigidBody does.
void tieRigidBodies(const Scene& scene, Body& body);

}  // namespace ringwatch
