#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Threshold mode at states that another program has on the device, of its own integrator: whether a step is certified
/// there, by a DeviceCertificate. Positions are read where they lie, nothing but flags and a bound comes to the host.
/// While every element is in its validity ball an observation is one pass over the elements; where the certificate is
/// lost, or a larger step is asked about, it is made again. Theorems 14 to 18, docs/theory/incremental_certificate.md;
/// that a certified step is stable for the tangent is Theorem 27, docs/theory/integrators.md.
class DeviceMonitor {
 public:
  /// limit: the integrator's largest stable h·omega. Mass, constraints and rules are those that the body has now; it
  /// must outlive the monitor. Throws InputError for a limit that is not > 0 and finite, and as DeviceBody and
  /// DeviceCertificate.
  DeviceMonitor(const Body& body, double limit);
  ~DeviceMonitor();
  DeviceMonitor(const DeviceMonitor&) = delete;
  DeviceMonitor& operator=(const DeviceMonitor&) = delete;

  std::int32_t nodeCount() const;
  /// The stream that reads positions, a cudaStream_t.
  std::uintptr_t stream() const;
  /// Has everything that was put into another stream, a cudaStream_t, come before what is read from now on.
  void waitFor(std::uintptr_t other);

  struct Report {
    bool certified = false;      ///< h is proven stable for the tangent at this state
    double safe = 0;             ///< s, the largest step proven there; 0 where none is
    bool renewed = false;        ///< the certificate was made again, or it was tried
    std::int64_t evaluated = 0;  ///< elements that had left their validity balls and were evaluated one by one
  };
  /// x: 3×N positions, m, node after node, in the memory of the device that the body is on; they are read before this
  /// returns. h: s; without one the largest proven step is found, from scratch. Throws InputError for an h that is not
  /// positive and finite and for an x that the device cannot read.
  Report observe(const double* x, std::optional<double> h);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch
