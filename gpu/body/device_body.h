#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/gpu/body/device_patches.h>

namespace ringwatch {

/// What a body on a device is made of. A `Body` has all of it; a program that needs no body on the CPU, as for meshes
/// of many millions of elements, hands it over without one.
struct DeviceBodyInput {
  const Mesh* mesh = nullptr;
  std::vector<Material> materials;             // one a block
  std::vector<const QuadratureRule*> rules;    // one a block; rules with shares at the mean are not on the device
  Eigen::VectorXd lumpedMass;                  // of each node, kg, > 0
  const Constraints* constraints = nullptr;    // nullptr: none
  const NodeVectors* externalForce = nullptr;  // 3×N, N; nullptr: none

  /// The input of a body made of a mesh and materials. The body must outlive the result. Throws InputError for a body
  /// with discrete forces.
  static DeviceBodyInput of(const Body& body);
};

/// A body whose state lives on a CUDA device, or on several of one host: positions, velocities and everything the
/// kernels need. Mass, constraints and loads are those it was made with. R: double, or float, which computes forces to
/// about 1e-6 of the stresses' size: state is kept as displacements, so that this does not depend on the size of the
/// body.
///
/// Forces are summed within a patch of elements in shared memory; nodes of several patches get a slot for each, summed
/// in the order of the patches. So every result is the same, to the last bit, in every run, and on any number of
/// devices: patches are shared out to them, and slots of nodes at patches of several devices are sent to all of these
/// (cutPlan).
///
/// Calls that return numbers wait for the device; step() and compute…() return at once. Nodal arrays are 3×N in the
/// mesh's numbering. Every call may throw DeviceError.
template <class R>
class DeviceBody {
 public:
  /// Throws InputError for elements or rules that the device does not have, for a mass that is not positive, and, with
  /// the need and what is free, when a device has too little memory: before anything is allocated on it. plan: of the
  /// mesh, when it is at hand. devices: numbers as CUDA has them, one for each part of the body, of which at most as
  /// many are made as there are patches; a number may come again, for several parts on one device. None: the current
  /// one.
  explicit DeviceBody(const DeviceBodyInput& input, const DevicePlan* plan = nullptr,
                      const std::vector<int>& devices = {});
  explicit DeviceBody(const Body& body, const std::vector<int>& devices = {})
      : DeviceBody(DeviceBodyInput::of(body), nullptr, devices) {}
  ~DeviceBody();
  DeviceBody(const DeviceBody&) = delete;
  DeviceBody& operator=(const DeviceBody&) = delete;

  std::int32_t nodeCount() const;
  std::int64_t elementCount() const;
  /// Memory that it takes on all devices, bytes.
  std::size_t bytes() const;
  /// The device of each part.
  std::vector<int> devices() const;
  /// Bytes that the devices send each other in a step; 0 on one.
  std::size_t bytesExchanged() const;

  /// Positions, m, and velocities, m/s. At the start: at rest in the reference configuration, constrained components
  /// already moving.
  void setPositions(const NodeVectors& x);
  void setVelocities(const NodeVectors& v);
  NodeVectors positions() const;
  NodeVectors velocities() const;

  /// Internal force at the device's positions, N.
  NodeVectors internalForce();
  /// K(x) direction with the exact tangent; direction 3×N.
  NodeVectors tangentProduct(const NodeVectors& direction);
  /// Strain and kinetic energy, J.
  double strainEnergy();
  double kineticEnergy();

  /// `count` steps of symplectic Euler of h seconds each: nothing is copied to the host, nothing waits. On one device
  /// they are CUDA graphs.
  void step(double h, std::int64_t count = 1);
  /// Steps taken so far.
  std::int64_t steps() const;

  /// Do the work of internalForce() and tangentProduct() without any copy, into the device's own arrays.
  void computeForce();
  void computeTangentProduct();
  /// Waits until the device is done.
  void synchronize() const;

  struct Impl;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

extern template class DeviceBody<double>;
extern template class DeviceBody<float>;

}  // namespace ringwatch
