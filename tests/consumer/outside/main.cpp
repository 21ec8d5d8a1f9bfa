// Uses ringwatch from outside: builds the smallest mesh and prints what the library knows of its element.
#include <ringwatch/elements/registry.h>
#include <ringwatch/meshes/mesh.h>

#include <cstdio>

int main() {
  const ringwatch::ElementInfo* tet = ringwatch::findElementByName("tet4");
  if (tet == nullptr) return 1;
  ringwatch::Mesh mesh;
  mesh.X.resize(3, tet->nodes);
  for (int a = 0; a < tet->nodes; ++a)
    for (int i = 0; i < 3; ++i)
      mesh.X(i, a) = tet->referenceNodes[static_cast<std::size_t>(a)][static_cast<std::size_t>(i)];
  mesh.blocks.push_back({tet->type, {0, 1, 2, 3}, {0}});
  std::printf("%zu nodes, %zu element of type %s\n", mesh.nodeCount(), mesh.elementCount(), tet->name.data());
  return mesh.nodeCount() == 4 && mesh.elementCount() == 1 ? 0 : 1;
}
