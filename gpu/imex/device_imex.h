#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <ringwatch/gpu/body/device_body.h>

namespace ringwatch {

struct DeviceImexOptions {
  double dissipation = 0.1;  ///< >= 0, <= 1: 0 none and second order, 1 implicit Euler
  double tolerance = 1e-8;   ///< of conjugate gradients: residual over right-hand side, in the preconditioner's norm
  int iterations = 200;      ///< of conjugate gradients, at most
};

/// The scheme of Imex on the device, on top of symplectic Euler: a step of all nodes, then the nodes of the
/// implicit elements take theirs back and solve
///   (M + beta h² K̂) (a + c v) = M (a₀ + c v),   c = α / (beta h), beta = (1 + α)²/4,
/// cluster by cluster with block-Jacobi preconditioned conjugate gradients, all clusters in one launch and without a
/// word to the host. K̂, the rest tangents turned and scaled with their elements, is that of the positions in every
/// step, where ImplicitCluster keeps it until an element has turned by 0.05 to 0.2 rad
/// (handlers/imex/cluster_matrix.h). The same, to the last bit, in every run. Theorem 34, docs/theory/handlers.md.
class DeviceImex {
 public:
  /// mesh: the body's. clusters: elements that share nodes, each node in one cluster at most (`clustersOf`). h: s, > 0.
  /// The body must outlive it. Throws InputError for options out of range, and, with need and free memory, when the
  /// device has too little.
  DeviceImex(DeviceBody<double>& body, const Mesh& mesh, const std::vector<std::vector<ElementRef>>& clusters, double h,
             const DeviceImexOptions& options = {});
  ~DeviceImex();
  DeviceImex(const DeviceImex&) = delete;
  DeviceImex& operator=(const DeviceImex&) = delete;

  /// Puts `count` steps of h onto the device, and returns at once.
  void step(std::int64_t count = 1);
  /// What became of the steps since the last status. Waits. After a step that failed the body is in the state before
  /// it: the steps until there are taken once more, from a copy.
  struct Status {
    std::int64_t steps = 0;  ///< taken
    std::string fault;       ///< why the next one failed; "" when none did
  };
  Status status();

  /// Iterations of conjugate gradients over all clusters and steps so far. Waits.
  std::int64_t iterations() const;
  /// Memory that it takes on the device, bytes.
  std::size_t bytes() const;

  struct Impl;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch
