#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include <ringwatch/app/run/simulation.h>

namespace ringwatch {

/// The erosion of a scene: elements that meet one of its criteria leave the body of a run. Their mass stays at their
/// nodes, which go on as point masses where no element is left; their strain energy counts as dissipated.
class RunErosion {
 public:
  /// The simulation must outlive this.
  explicit RunErosion(Simulation& simulation);

  /// Takes the elements out of the body that meet a criterion at the state before step k; what depends on them is built
  /// again. Records of them are in the result. False when none would be left, which ends the run.
  bool makeDue(std::int64_t k);

 private:
  /// What an element met, in a sentence of few words; empty where it stays.
  struct Fault {
    const char* cause = nullptr;
    double value = 0;
  };
  std::vector<std::vector<Fault>> faults() const;
  void takeOut(const std::vector<std::vector<Fault>>& faults, std::int64_t k);

  Simulation& run_;
  std::vector<std::size_t> surfaces_;  // of scene.contacts, those with the surface that are left
};

}  // namespace ringwatch
