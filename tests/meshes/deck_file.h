#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/mesh_io.h>

#include "mesh_test_tools.h"

namespace ringwatch::test {

/// A deck in a folder of its own, read as a mesh.
class DeckFile : public ::testing::Test {
 public:
  /// name: of the file, whose extension may tell its dialect.
  explicit DeckFile(const std::string& name) : path(folder_.path() / name) {}

  Mesh read(const std::string& deck) {
    std::ofstream(path) << deck;
    return loadMesh(path, &notes);
  }
  std::string error(const std::string& deck) {
    try {
      read(deck);
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  }

 private:
  TemporaryFolder folder_;

 public:
  const std::filesystem::path path;
  std::vector<std::string> notes;
};

}  // namespace ringwatch::test
