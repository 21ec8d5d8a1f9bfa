// One harness for what reads the files of others: the environment variable FUZZ_TARGET names a row of the table. An
// input is read, or is refused by an error of ringwatch; whatever else happens is a finding.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <check/proof.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/scratch_folder.h>
#include <ringwatch/meshes/mesh_io.h>
#include <tests/check/seal.h>

namespace ringwatch {
namespace {

using Path = std::filesystem::path;

void write(const Path& file, std::string_view bytes) { std::ofstream(file, std::ios::binary) << bytes; }
void readMesh(const Path& file, const std::string& bytes) {
  write(file, bytes);
  loadMesh(file);
}

struct Target {
  std::string_view name;
  const char* file;  // what the input is called; its ending says the format
  void (*read)(const Path& file, const std::string& bytes);
};
constexpr Target targets[] = {
    {"msh", "input.msh", readMesh},
    {"vtu", "input.vtu", readMesh},
    {"vtk", "input.vtk", readMesh},
    {"frd", "input.frd", readMesh},
    {"inp", "input.inp", readMesh},
    {"k", "input.k", readMesh},
    {"tetgen", "input.node",  // two files, the elements behind the first '#', which begins a comment
     [](const Path& file, const std::string& bytes) {
       const std::size_t nodes = std::min(bytes.find('#'), bytes.size());
       write(Path(file).replace_extension(".ele"), std::string_view(bytes).substr(nodes));
       readMesh(file, bytes.substr(0, nodes));
     }},
    {"certificate", "",
     [](const Path&, const std::string& bytes) {
       constexpr std::size_t checksum = 8;
       if (bytes.size() >= checksum) check::verify(test::sealed(bytes));
     }},
};

const Target& chosenTarget() {
  const char* const name = std::getenv("FUZZ_TARGET");
  for (const Target& target : targets)
    if (name && target.name == name) return target;
  for (const Target& target : targets) std::printf("%s\n", target.name.data());
  std::fflush(stdout);
  std::_Exit(2);
}

}  // namespace
}  // namespace ringwatch

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ringwatch::Target& target = ringwatch::chosenTarget();
  static const ringwatch::ScratchFolder folder;
  try {
    target.read(folder.path() / target.file, std::string(reinterpret_cast<const char*>(data), size));
  } catch (const ringwatch::InputError&) {
  } catch (const ringwatch::NumericalError&) {
  }
  return 0;
}
