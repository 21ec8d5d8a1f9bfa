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
    DeviceVector<std::uint32_t> balls, centres;
    DeviceVector<std::int32_t> outsidePlace;
    DeviceVector<unsigned> counters;
  };

  /// What belongs to one part of the body, on its device.
  struct Part {
    explicit Part(DevicePart<double>& of);
    CertificateArguments arguments(std::size_t b, double sigma, cudaStream_t stream) const {
      return {body.blocks[b].view, body.nodes, body.blocks[b].law, blocks[b].view, sums, sigma, stream};
    }
    DevicePart<double>& body;
    std::vector<Block> blocks;
    NodalSums sums;
    DeviceVector<double> slots, nodeSums, factors, nodal;
    DeviceVector<unsigned long long> boundBits;
    DeviceVector<CertificateFlags> flags;
    DeviceStream side;
    DeviceEvent forked, joined;
  };

  explicit Impl(DeviceBody<double>& deviceBody);
  /// Puts an operation on the elements of all blocks into the parts' streams.
  void launch(CertificateOperations::Launch CertificateOperations::*which, double sigma);
  /// The bound with the weights as they are: values and nodal sums.
  double evaluate();
  /// The largest of the bounds of all nodes, whose sums are of these numbers of the elements.
  double boundOf(DeviceVector<double> Block::*values);
  void distribute(double forSigma);
  void enqueueStep();
  CertificateFlags flags() const;
  /// The two statements of CertificateState at the device's positions, from exact tangents; for tests. The largest
  /// relative excess: <= 0 when both hold, but for rounding.
  double verify();

  DeviceBody<double>::Impl& body;
  std::vector<std::unique_ptr<Part>> parts;
  std::unique_ptr<SlotExchange> exchange;  // of the nodal sums' slots
  double sigma = 0;
  double tight = 0;  // the last bound
  bool started = false, certified = false;
  std::unique_ptr<DeviceGraph> graphs[2];
};

}  // namespace ringwatch
