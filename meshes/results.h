#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/meshes/formats/vtu_writer.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A state in the results of another program.
struct ResultEntry {
  std::optional<double> time;             // s
  std::optional<std::int64_t> increment;  // steps taken up to it
  std::optional<double> step;             // s, taken from here, where the file tells it
  std::string where;                      // "bar.frd:297", for messages
};

/// States that a program has left in files: a .pvd with its .vtu files, .vtu or legacy .vtk files, in the order of
/// their times where all have one and else as given, or an .frd file of CalculiX (text).
class ResultSeries {
 public:
  /// displacement: the name of the field, m; "" takes the first of the usual names that there is, and without any the
  /// points themselves, which then are the deformed positions, with those of the first state at rest. notes: what a
  /// user may want to know. Throws InputError, "FILE:LINE: …", for files that cannot be read, results without states,
  /// and states whose nodes or elements are not those of the first.
  ResultSeries(const std::vector<std::filesystem::path>& files, const std::string& displacement,
               std::vector<std::string>* notes);

  /// At rest.
  const Mesh& mesh() const { return mesh_; }
  const std::vector<ResultEntry>& entries() const { return entries_; }
  /// Positions of state i, 3×N, m. They may be not finite, where the program went on after it had lost the run.
  NodeVectors positions(std::size_t i) const { return positions_(i); }
  /// Elements that the other program has deleted in state i, [block][element]; empty where its files tell of none.
  const std::vector<std::vector<bool>>& deleted(std::size_t i) const {
    static const std::vector<std::vector<bool>> none;
    return i < deleted_.size() ? deleted_[i] : none;
  }
  /// How the positions come about: the name of the field, or "" for deformed points.
  const std::string& displacement() const { return displacement_; }

 private:
  void openFrd(const std::filesystem::path& file, const std::string& displacement, std::vector<std::string>* notes);
  void openVtk(const std::vector<std::filesystem::path>& files, const std::string& displacement,
               std::vector<std::string>* notes);

  struct VtkFile {
    std::filesystem::path path;
    std::optional<double> time;  // s, of a .pvd
  };
  void openFrames(const std::vector<VtkFile>& frames, const std::string& displacement, std::vector<std::string>* notes);

  Mesh mesh_;
  std::vector<ResultEntry> entries_;
  std::function<NodeVectors(std::size_t)> positions_;
  std::vector<std::vector<std::vector<bool>>> deleted_;  // by state
  std::string displacement_;
};

/// The files of a .pvd collection with their times. Throws InputError when it cannot be read.
std::vector<PvdEntry> readPvd(const std::filesystem::path& file);

}  // namespace ringwatch
