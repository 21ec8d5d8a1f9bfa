#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <mpi.h>

#include <ringwatch/base/exact_sum.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// The processes of a run, which hold a part of a body each and talk by MPI. All functions that are not const are
/// collective: every rank calls them in the same order. The communicator must outlive this.
class Ranks {
 public:
  explicit Ranks(MPI_Comm communicator);

  MPI_Comm communicator() const { return communicator_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  /// Ranks on this rank's machine, this one among them.
  int onThisMachine() const { return onThisMachine_; }
  /// "rank 3 of 8 on node17", counted from 0.
  std::string name() const;

  /// Replaces each number by the largest of all ranks; NaN where one is. meanwhile: called, unless empty, while the
  /// others are waited for.
  void largest(std::span<double> numbers, const std::function<void()>& meanwhile = {});
  /// Replaces each sum by that of all ranks, the same bits on each, whoever had which terms.
  void sum(std::span<ExactSum> sums);
  /// The least of all ranks.
  std::int64_t least(std::int64_t number);
  /// The first rank that says yes; size() where none does.
  int firstWhere(bool yes);
  /// A rank's bytes, on all of them.
  void share(void* data, std::size_t bytes, int from);
  /// A rank's text, on all of them.
  std::string shareText(std::string text, int from);
  /// The first of the elements that ranks have found, by block and number; nothing where none has found one. On all of
  /// them.
  std::optional<ElementRef> first(std::optional<ElementRef> found);

  /// Reductions begun so far: messages that cost a latency of the whole machine.
  std::int64_t reductions() const { return reductions_; }

 private:
  MPI_Comm communicator_;
  int rank_ = 0, size_ = 1, onThisMachine_ = 1;
  std::int64_t reductions_ = 0;
};

}  // namespace ringwatch
