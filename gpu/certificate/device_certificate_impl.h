#pragma once
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/certificate/certificate_operations.h>
#include <ringwatch/gpu/certificate/device_certificate.h>

namespace ringwatch {

struct DeviceCertificate::Impl {
  struct Block {
    CertificateOperations operations;
    int elementNodes = 0;
    CertificateView view;
    DeviceVector<double> weights, value, allowance, strainNorm, outsideF;
    DeviceVector<std::uint32_t> balls;
    DeviceVector<std::int32_t> outsidePlace;
    DeviceVector<unsigned> counters;
  };

  explicit Impl(DeviceBody<double>& deviceBody);
  void launch(CertificateOperations::Launch CertificateOperations::*which, double sigma);
  /// The bound with the weights as they are: values and nodal sums.
  double evaluate();
  void distribute(double forSigma);
  void enqueueStep();
  /// The two statements of CertificateState at the device's positions, from exact tangents; for tests. The largest
  /// relative excess: <= 0 when both hold, but for rounding.
  double verify();

  DeviceBody<double>::Impl& body;
  std::vector<Block> blocks;
  NodalSums sums;
  DeviceVector<double> slots, nodeSums, factors, nodal;
  DeviceVector<unsigned long long> boundBits;
  DeviceVector<CertificateFlags> flags;
  cudaStream_t side = nullptr;
  cudaEvent_t forked = nullptr, joined = nullptr;
  double sigma = 0;
  bool started = false, certified = false;
  std::unique_ptr<DeviceGraph> graphs[2];
};

}  // namespace ringwatch
