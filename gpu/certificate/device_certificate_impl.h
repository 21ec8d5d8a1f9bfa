#pragma once
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/certificate/certificate_operations.h>
#include <ringwatch/gpu/certificate/device_certificate.h>

namespace ringwatch {

struct DeviceCertificate::Impl {
  struct Block {
    CertificateOperations operations;
    int elementNodes = 0;
    /// Of a step and, in small bodies, the next one, which differ in their lists of elements that have left.
    CertificateView views[2];
    DeviceVector<double> weights, value, allowance, strainNorm, outsideF;
    DeviceVector<std::uint32_t> balls, centres, newBalls;
    DeviceVector<std::int32_t> outsidePlace;
    DeviceVector<unsigned> counters;
  };

  /// What belongs to one part of the body, on its device.
  struct Part {
    Part(DevicePart<double>& of, bool besideNext);
    CertificateArguments arguments(std::size_t b, double sigma, cudaStream_t stream, std::size_t list = 0) const {
      return {body.blocks[b].view, body.nodes, body.blocks[b].law, blocks[b].views[list], sums, sigma, stream};
    }
    DevicePart<double>& body;
    std::vector<Block> blocks;
    NodalSums sums;
    DeviceVector<double> slots, nodeSums, factors, nodal;
    DeviceVector<unsigned long long> boundBits;
    DeviceVector<CertificateFlags> flags;
    DeviceVector<BallPlacement> placementOfBlock[2];  // by list
    DeviceVector<unsigned> placed;
    BallPlacements placements[2];
    DeviceStream side;
    DeviceEvent forked, joined[2];  // of the side stream; joined by list
  };

  Impl(DeviceBody<double>& deviceBody, std::optional<bool> wanted);
  /// Puts an operation on the elements of all blocks into the parts' streams.
  void launch(CertificateOperations::Launch CertificateOperations::*which, double sigma);
  /// The bound with the weights as they are: values and nodal sums.
  double evaluate();
  /// The largest of the bounds of all nodes, whose sums are of these numbers of the elements.
  double boundOf(DeviceVector<double> Block::*values);
  void distribute(double forSigma);
  /// Puts steps into the streams.
  void enqueueSteps(std::int64_t count);
  CertificateFlags flags() const;
  /// The two statements of CertificateState at the device's positions, from exact tangents; for tests. The largest
  /// relative excess: <= 0 when both hold, but for rounding.
  double verify();

  DeviceBody<double>::Impl& body;
  /// Elements that have left their balls are evaluated beside the shared nodes of their step; in small bodies, where a
  /// step would wait for them, beside the patches of the next one as well. These find such an element outside its old
  /// ball once more. New balls are put in place behind them.
  bool besideNext;
  std::vector<std::unique_ptr<Part>> parts;
  std::unique_ptr<SlotExchange> exchange;  // of the nodal sums' slots
  double sigma = 0;
  double tight = 0;  // the last bound
  bool started = false, certified = false;
  std::unique_ptr<DeviceGraph> graphs[2];
};

}  // namespace ringwatch
