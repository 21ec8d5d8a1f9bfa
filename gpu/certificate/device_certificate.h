#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include <ringwatch/gpu/body/device_body.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/incremental/rebuild_policy.h>

namespace ringwatch {

/// Threshold mode on the device: proves, for the state before every step, that the step h is certified, that is
/// lambda_max(M⁻¹K(x)) <= sigma for the sigma that h stands for; the mathematics is IncrementalNodalBound's. Weights
/// D_e and allowances stay frozen while every element is in a ball around the deformation gradient at which it was
/// evaluated last. The pass that computes forces tests the balls; elements that have left are evaluated beside others'
/// work, in the same graph. Nothing is asked of the host: what was found stays in flags until the host reads them.
///
/// Unlike IncrementalNodalBound it distributes no allowances again for single elements: renew() does so for all.
/// Theorems 14 to 18, docs/theory/incremental_certificate.md, with fixed allowances between two calls of renew().
class DeviceCertificate {
 public:
  /// The body must outlive the certificate. besideNext: elements that have left are evaluated beside the patches of the
  /// next step too, which evaluates them once more; where that is not given, in small bodies, whose steps would wait
  /// for them. What is proven is the same. Throws InputError, with need and free memory, when the device has too
  /// little.
  explicit DeviceCertificate(DeviceBody<double>& body, std::optional<bool> besideNext = {});
  ~DeviceCertificate();
  DeviceCertificate(const DeviceCertificate&) = delete;
  DeviceCertificate& operator=(const DeviceCertificate&) = delete;

  /// The block nodal bound at the device's positions, from scratch: weights from (K_aa)^½, then `sweeps` sweeps.
  /// rad²/s². NaN when positions or tangent are not finite.
  UpperBound bound(int sweeps = RebuildPolicy{}.sweeps);
  /// Proves lambda_max <= sigma (rad²/s², > 0) at the device's positions and distributes allowances for it: with the
  /// weights at hand if they do, else from scratch. Forgets what was lost before. False when it cannot be proven.
  bool certify(double sigma);
  /// Proves the last sigma again, at a later state, as certify().
  bool renew();

  /// `count` checked steps of symplectic Euler of h seconds each: force, ball test and step in one pass over the
  /// elements. Returns at once. The steps are certified while status() says so, if sigma belongs to h.
  void step(double h, std::int64_t count = 1);

  /// What became of the checked steps since certify() or renew(). Waits for the device.
  struct Status {
    bool certified = false;      ///< certify() succeeded, and every step since was proven at the state before it
    std::int64_t lostAt = -1;    ///< the first step that was not, counted from there
    std::int64_t checked = 0;    ///< steps
    std::int64_t evaluated = 0;  ///< elements evaluated again
    bool nearlyLost = false;     ///< an element has come close to its allowance: time to renew
  };
  Status status() const;

  struct Impl;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch
