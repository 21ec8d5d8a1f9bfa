// The extension _device: the certificate on a GPU, at positions that other packages hold there.
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <ringwatch/base/error.h>
#include <ringwatch/gpu/certificate/device_monitor.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/python/errors.h>
#include <ringwatch/python/held.h>
#include <ringwatch/python/results.h>

namespace ringwatch::python {
namespace {

/// The structures of DLPack ("Data Structures", dmlc.github.io/dlpack) in its first form, which every producer gives
/// unless asked for a newer one.
namespace dlpack {
struct Device {
  std::int32_t type, id;
};
struct DataType {
  std::uint8_t code, bits;
  std::uint16_t lanes;
};
struct Tensor {
  void* data;
  Device device;
  std::int32_t dimensions;
  DataType type;
  std::int64_t* shape;
  std::int64_t* strides;  // in elements; nullptr: C order
  std::uint64_t byteOffset;
};
struct ManagedTensor {
  Tensor tensor;
  void* context;
  void (*deleter)(ManagedTensor*);
};
constexpr std::int32_t cuda = 2, cudaManaged = 13;
constexpr std::uint8_t real = 2;
}  // namespace dlpack

/// What is asked of positions, and what was given in its place.
[[noreturn]] void refuse(const std::string& given, std::int64_t nodes) {
  throw InputError(joinText("x: ", given, "; must be an array of float64 of shape (", nodes,
                            ", 3) in C order on the GPU of the body"));
}

/// A tensor of DLPack, given back to its owner in the end.
class TakenTensor {
 public:
  explicit TakenTensor(const py::object& capsule) : capsule_(capsule) {
    held_ = static_cast<dlpack::ManagedTensor*>(PyCapsule_GetPointer(capsule.ptr(), "dltensor"));
    if (!held_) throw py::error_already_set();
    if (PyCapsule_SetName(capsule.ptr(), "used_dltensor") != 0) throw py::error_already_set();
  }
  ~TakenTensor() {
    if (held_->deleter) held_->deleter(held_);
  }
  TakenTensor(const TakenTensor&) = delete;
  TakenTensor& operator=(const TakenTensor&) = delete;

  const double* positions(std::int64_t nodes) const {
    const dlpack::Tensor& t = held_->tensor;
    if (t.device.type != dlpack::cuda && t.device.type != dlpack::cudaManaged) refuse("not on a CUDA device", nodes);
    if (t.type.code != dlpack::real || t.type.bits != 64 || t.type.lanes != 1)
      refuse(joinText("numbers of ", int{t.type.bits}, " bits that are no float64"), nodes);
    if (t.dimensions != 2 || t.shape[0] != nodes || t.shape[1] != 3) {
      std::string shape;
      for (std::int32_t i = 0; i < t.dimensions; ++i) shape += joinText(i > 0 ? ", " : "", t.shape[i]);
      refuse(joinText("of shape (", shape, ")"), nodes);
    }
    if (t.strides && (t.strides[0] != 3 || t.strides[1] != 1)) refuse("not in C order", nodes);
    return reinterpret_cast<const double*>(static_cast<const char*>(t.data) + t.byteOffset);
  }

 private:
  py::object capsule_;
  dlpack::ManagedTensor* held_;
};

/// A monitor for one thread at a time.
struct HeldDeviceMonitor {
  HeldDeviceMonitor(const Body& body, double limit) : monitor(body, limit) {}
  DeviceMonitor monitor;
  std::mutex turn;
};

std::unique_ptr<HeldDeviceMonitor> monitorOf(HeldBody& held, double limit) {
  if (const DeviceStatus status = deviceStatus(); !status.available)
    throw InputError(joinText("DeviceMonitor: ", status.text));
  return reading(held, [&] { return std::make_unique<HeldDeviceMonitor>(held.body, limit); });
}

py::object observe(HeldDeviceMonitor& self, const double* x, std::optional<double> h,
                   std::optional<std::uintptr_t> after) {
  static const ResultType& type = *new ResultType("DeviceReport", 5);
  const DeviceMonitor::Report report = unlocked<std::unique_lock<std::mutex>>(self.turn, [&] {
    if (after) self.monitor.waitFor(*after);
    return self.monitor.observe(x, h);
  });
  return type(orNone(h, real), flag(report.certified), real(report.safe), flag(report.renewed),
              integer(report.evaluated));
}

}  // namespace
}  // namespace ringwatch::python

PYBIND11_MODULE(_device, module) {
  using namespace ringwatch::python;
  py::options options;
  options.disable_function_signatures();  // they stand in _device.pyi
  translateErrors();
  py::module_::import("ringwatch._ringwatch");  // has the type Body
  py::class_<HeldDeviceMonitor>(module, "Monitor")
      .def(py::init(&monitorOf), py::keep_alive<1, 2>())
      .def_property_readonly("node_count", [](HeldDeviceMonitor& self) { return self.monitor.nodeCount(); })
      .def_property_readonly("stream", [](HeldDeviceMonitor& self) { return self.monitor.stream(); })
      .def("observe_tensor",
           [](HeldDeviceMonitor& self, const py::object& capsule, std::optional<double> h) {
             const TakenTensor tensor(capsule);
             return observe(self, tensor.positions(self.monitor.nodeCount()), h, std::nullopt);
           })
      .def("observe_pointer",
           [](HeldDeviceMonitor& self, std::uintptr_t x, std::optional<double> h, std::optional<std::uintptr_t> after) {
             return observe(self, reinterpret_cast<const double*>(x), h, after);
           });
}
