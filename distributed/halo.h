#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// Gives ghosts the values of their owners: a message to each neighbour and one from it. Collective. Both arguments
/// must outlive it.
class Halo final : private NodeArrival {
 public:
  Halo(Ranks& ranks, const RankBody& part) : ranks_(ranks), part_(part) {}
  ~Halo();
  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  /// One vector a node, 3×N.
  void exchange(NodeVectors& vectors) { exchange(vectors.data(), 3); }
  /// Six numbers a node.
  void exchange(Eigen::Matrix<double, 6, Eigen::Dynamic>& values) { exchange(values.data(), 6); }

  /// Sends the owners' values and comes back; ghosts have them after finish(). Until then the vectors must stay where
  /// they are, and their ghosts are not to be written. One exchange is under way at a time: another one finishes it.
  void begin(NodeVectors& vectors) { begin(vectors.data(), 3); }
  /// Waits for what is under way, if anything is.
  void finish();
  /// For StepEvaluation::arrival: a pass of the part's body at positions whose exchange is under way finishes it behind
  /// the elements that need no ghost. nullptr where nothing is under way.
  NodeArrival* arrival() { return underWay_ ? this : nullptr; }

  /// What this rank has sent: messages, and bytes of their contents; and what it has received.
  struct Traffic {
    std::int64_t exchanges = 0, messages = 0, bytes = 0;
    std::int64_t received = 0;  // bytes
    std::int64_t hidden = 0;    // bytes of these that had come, behind work, when they were waited for
    double waited = 0;          // s, until the rest had come
  };
  const Traffic& traffic() const { return traffic_; }
  /// Nodes that this rank sends in an exchange, counted once for each rank that has one as a ghost.
  std::int64_t sentNodes() const;

 private:
  /// Buffers and requests of messages of so many numbers a node, made once.
  struct Channel {
    std::vector<double> sent, received;
    std::vector<MPI_Request> requests;
  };
  Channel& channelOf(int numbers);
  /// Of so many numbers a node.
  void exchange(double* data, int numbers);
  void begin(double* data, int numbers);
  void countArrived();
  std::span<const std::int64_t> patchesWithout() const override { return part_.patchesOfOwned(); }
  std::span<const std::int64_t> patchesWith() const override { return part_.patchesWithGhosts(); }
  void progress() override { countArrived(); }
  void complete() override { finish(); }

  Ranks& ranks_;
  const RankBody& part_;
  std::map<int, Channel> channels_;
  Channel* underWay_ = nullptr;
  double* data_ = nullptr;    // of the exchange under way
  int numbers_ = 0;           // a node, of it
  std::vector<int> arrived_;  // for MPI_Testsome
  Traffic traffic_;
};

}  // namespace ringwatch
