#pragma once
#include <memory>
#include <vector>

#include <ringwatch/gpu/body/device_body.h>

namespace ringwatch {

/// ReducedRing on the device, in double precision, for bodies of four-node tetrahedra: the largest eigenvalue of
/// M^-½ K M^-½ at each element's own nodes, K assembled from node and edge blocks at the device's positions. The same,
/// to the last bit, in every run. Theorem 9, docs/theory/rings_and_rayleigh.md.
class DeviceRings {
 public:
  /// The body must outlive the rings. Throws InputError for other elements, and, with need and free memory, when the
  /// device has too little.
  explicit DeviceRings(DeviceBody<double>& body);
  ~DeviceRings();
  DeviceRings(const DeviceRings&) = delete;
  DeviceRings& operator=(const DeviceRings&) = delete;

  /// Evaluates all rings into the device's own arrays. Returns at once.
  void compute();
  /// The highest ring of the last evaluation.
  struct Highest {
    double value = 0;    ///< rad²/s², lowered by rounding: a proven lower bound; NaN when a tangent is not finite
    ElementRef element;  ///< where; of no meaning in a body without elements, whose value is 0
  };
  /// Evaluates and waits.
  Highest highest();
  /// Evaluates and copies: [block][element], rad²/s².
  std::vector<std::vector<double>> evaluate();

  struct Impl;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch
