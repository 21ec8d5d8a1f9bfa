#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A 3-D flex of a MuJoCo model: a soft body of linear tetrahedra with a mass at each vertex.
struct Flex {
  std::string name;
  std::string origin;                                   // "model.xml:12: <flexcomp>", for messages
  std::vector<Eigen::Vector3d> points;                  // m, in the world
  std::vector<std::array<std::int32_t, 4>> tetrahedra;  // positive
  std::vector<double> masses;                           // kg, of each vertex
  std::vector<std::int32_t> pinned;                     // vertices that are held, ascending
  double young = 0, poisson = 0;                        // Pa; as the model has them
  double damping = 0;                                   // s, by which the stiffness makes the damping
  double edgeDamping = 0;                               // N s/m, of a dashpot along each edge

  // Node sets of the mesh: vertices of one of the different masses, and those that are held.
  std::string massSet(std::size_t group) const {
    return differentMasses().size() == 1 ? name : name + ".mass" + std::to_string(group);
  }
  std::string pinnedSet() const { return name + ".pinned"; }
  /// kg, ascending, each once.
  std::vector<double> differentMasses() const;
};

/// What of a MuJoCo model (MJCF) bears on its 3-D flexes.
struct FlexModel {
  std::vector<Flex> flexes;
  double timestep = 0.002;           // s
  std::string integrator = "Euler";  // by MuJoCo's name
  std::string optionOrigin;          // "model.xml:2: <option>", or the file where nothing sets the integrator
  Eigen::Vector3d gravity{0, 0, -9.81};
  std::vector<std::string> notes;  // what is left out, with file and line
  /// Whether what is left out may let a larger step be stable: inertia or implicit damping of vertices.
  bool leavesOutWhatEnlargesTheStep = false;

  /// Whether forces that depend on velocities are implicit, damping along edges among them.
  bool implicitDamping() const { return integrator.starts_with("implicit"); }
};

/// Whether a file is a MuJoCo model, by its root element. False for one that cannot be read.
bool isMjcfFile(const std::filesystem::path& file);

/// Reads a MuJoCo model with the files that it includes: every `<flexcomp dim="3">` and `<flex dim="3">` that deforms.
/// Throws InputError "FILE:LINE: …" for what is wrong, for what changes the motion of a flex and is not here, and for a
/// model without such a flex.
FlexModel readFlexModel(const std::filesystem::path& file);

/// The flexes as one mesh, a block each, in order. Nodes and elements have MuJoCo's numbers, counted through. Sets: the
/// elements and the vertices of each flex by its name, and those of Flex.
Mesh meshOfFlexes(const FlexModel& model);

}  // namespace ringwatch
