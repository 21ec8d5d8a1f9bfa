#pragma once
#include <cstddef>

#include <ringwatch/app/run/simulation.h>

namespace ringwatch {

/// Throws InputError where the scene cuts and the mesh has elements that cannot be cut.
void requireCuttable(const Scene& scene, const Mesh& mesh);

/// The cuts of a scene, made in the body of a run when their time has come.
class RunCuts {
 public:
  /// The simulation must outlive this.
  explicit RunCuts(Simulation& simulation) : run_(simulation) {}

  /// Makes the cuts that are due at the state: the body is the cut one then, with the state carried over, and what
  /// depends on the mesh is built again. Records of them are in the result; a cut that opens nothing gets a note.
  void makeThoseDue();

 private:
  bool due() const;
  void make(const Scene::Cut& wanted);
  void moveTo(const CutMesh& made, CutRecord& record);
  double kineticEnergy() const;
  std::int64_t handledElements() const;

  Simulation& run_;
  std::size_t next_ = 0;  // of the scene's
};

}  // namespace ringwatch
