#include <ringwatch/meshes/mesh.h>
