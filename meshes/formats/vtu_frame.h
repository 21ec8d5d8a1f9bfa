#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A named number at every element of a frame, in the order of blocks and elements.
struct FrameField {
  std::string name;
  bool integer = false;  // of an integer type in the file
  std::vector<double> values;
};

/// A .vtu file as it is: what loadVtuState leaves out of a frame of a run, and without its checks of the shapes.
struct VtuFrame {
  Mesh mesh;                             // X: the points of the file, m, deformed ones in a frame of a run
  std::vector<FrameField> cells;         // fields of one component, without sets and numbers of the file
  std::map<std::string, double> values;  // field data of one number
};

/// Reads a .vtu file. Throws InputError as readMesh does.
VtuFrame readVtuFrame(const std::filesystem::path& path);

}  // namespace ringwatch
