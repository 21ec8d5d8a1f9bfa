#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// Gives ghosts the values of their owners: a message to each neighbour and one from it. Collective. Both arguments
/// must outlive it.
class Halo {
 public:
  Halo(Ranks& ranks, const RankBody& part) : ranks_(ranks), part_(part) {}
  ~Halo();
  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  /// One vector a node, 3×N.
  void exchange(NodeVectors& vectors) { exchange({{vectors.data(), 3}}); }
  /// Two vectors a node in one message.
  void exchange(NodeVectors& first, NodeVectors& second) { exchange({{first.data(), 3}, {second.data(), 3}}); }
  /// Six numbers a node.
  void exchange(Eigen::Matrix<double, 6, Eigen::Dynamic>& values) { exchange({{values.data(), 6}}); }

  /// What this rank has sent: messages, and bytes of their contents.
  struct Traffic {
    std::int64_t exchanges = 0, messages = 0, bytes = 0;
  };
  const Traffic& traffic() const { return traffic_; }
  /// Nodes that this rank sends in an exchange, counted once for each rank that has one as a ghost.
  std::int64_t sentNodes() const;

 private:
  struct Field {
    double* data;
    int numbers;  // a node
  };
  /// Buffers and requests of messages of so many numbers a node, made once.
  struct Channel {
    std::vector<double> sent, received;
    std::vector<MPI_Request> requests;
  };
  Channel& channelOf(int numbers);
  void exchange(std::initializer_list<Field> fields);

  Ranks& ranks_;
  const RankBody& part_;
  std::map<int, Channel> channels_;
  Traffic traffic_;
};

}  // namespace ringwatch
