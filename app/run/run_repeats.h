#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/app/run/simulation.h>

namespace ringwatch {

/// The going back of a run with on_violation = "repeat": each stretch between two observations ends with steps that are
/// certified at both of its ends, or is taken again from its beginning with smaller steps.
class RunRepeats {
 public:
  /// The simulation must outlive this.
  explicit RunRepeats(Simulation& simulation) : run_(simulation) {}

  /// Keeps all of the run before its state is observed, where that is due. A copy of its state and of what its monitor
  /// knows, some 100 bytes a tet4.
  void keep();
  /// A state whose step is certified, by an observation of it, is the one to go back to from here on.
  void noteCertified(const MonitorReport& report);
  /// Where a report of the state has no certified step, or the state is not finite: goes back to the last certified
  /// state, and is true. Ends the run where it has been there as often as the scene allows.
  bool goBack(const MonitorReport& report);
  /// Observes the state at the end of the run, which no step leaves, and goes back from it likewise.
  bool goBackFromEnd();
  /// Goes back to the last certified state, for a checkpoint: a run that is resumed there has the bits of one that goes
  /// on. False where the run is there, or has none.
  bool returnToCertified();

 private:
  struct Kept {
    State state;
    RunResult result;
    std::string memory;  // of the parts, by SavingArchive
    nlohmann::ordered_json steps, output;
    std::vector<double> moved;  // prescribedVelocities
    Verdict lastVerdict = Verdict::notCertified;
  };
  void restore(const Kept& kept);
  double smallerStep(const MonitorReport& report) const;

  Simulation& run_;
  std::optional<Kept> kept_, certified_;
  std::int64_t fromThere_ = 0;  // repeats from the certified one
};

}  // namespace ringwatch
