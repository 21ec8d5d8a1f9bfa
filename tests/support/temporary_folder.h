#pragma once
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <ringwatch/base/scratch_folder.h>

namespace ringwatch::test {

inline void writeBytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}
inline std::string readBytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own for a test, which goes away with everything in it.
class TemporaryFolder : public ScratchFolder {
 public:
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path() / name; }
  std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const {
    writeBytes(path() / name, text);
    return path() / name;
  }
  std::string read(const std::filesystem::path& name) const { return readBytes(path() / name); }
  std::size_t fileCount() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path()), {}));
  }
};

}  // namespace ringwatch::test
