#pragma once
#include <cuda_runtime_api.h>

#include <ringwatch/gpu/body/device_body.h>
#include <ringwatch/gpu/body/patch_operations.h>
#include <ringwatch/gpu/device_vector.h>

namespace ringwatch {

/// A stream that destroys itself.
class DeviceStream {
 public:
  DeviceStream() { checkCuda(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "cudaStreamCreate"); }
  ~DeviceStream() { cudaStreamDestroy(stream_); }
  DeviceStream(const DeviceStream&) = delete;
  DeviceStream& operator=(const DeviceStream&) = delete;
  operator cudaStream_t() const { return stream_; }  // NOLINT(google-explicit-constructor): it is one
  void synchronize() const { checkCuda(cudaStreamSynchronize(stream_), "the device's work"); }

 private:
  cudaStream_t stream_ = nullptr;
};

/// Work put into a stream, captured to be launched as a whole.
class DeviceGraph {
 public:
  /// Captures what enqueue() puts into the stream.
  template <class Enqueue>
  DeviceGraph(cudaStream_t stream, const Enqueue& enqueue) {
    checkCuda(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), "begin of a graph");
    cudaGraph_t graph = nullptr;
    try {
      enqueue();
    } catch (...) {
      cudaStreamEndCapture(stream, &graph);
      cudaGraphDestroy(graph);
      throw;
    }
    checkCuda(cudaStreamEndCapture(stream, &graph), "end of a graph");
    const cudaError_t status = cudaGraphInstantiate(&executable_, graph, 0);
    cudaGraphDestroy(graph);
    checkCuda(status, "cudaGraphInstantiate");
  }
  ~DeviceGraph() { cudaGraphExecDestroy(executable_); }
  DeviceGraph(const DeviceGraph&) = delete;
  DeviceGraph& operator=(const DeviceGraph&) = delete;
  void launch(cudaStream_t stream) const { checkCuda(cudaGraphLaunch(executable_, stream), "cudaGraphLaunch"); }

 private:
  cudaGraphExec_t executable_ = nullptr;
};

template <class R>
struct DeviceBody<R>::Impl {
  struct Block {
    ElementType type;
    std::size_t lawIndex = 0;
    int elementNodes = 0, threads = 0, points = 0;  // points at which geometry is stored
    std::size_t elementCount = 0;
    std::vector<std::int32_t> elements;  // [patch][thread] position in the mesh block, -1: none
    PatchOperations<R> operations;
    LawParameters law;
    BlockView<R> view;
    DeviceVector<DevicePatch> patches;
    DeviceVector<std::uint16_t> corners, rows;
    DeviceVector<std::int32_t> nodes, groupRow;
    DeviceVector<R> geometry;
  };

  Impl(const DeviceBodyInput& input, const DevicePlan& plan);
  /// geometry: of the block's points, as tabulateGeometry makes it.
  void addBlock(const DeviceBodyInput& input, const DeviceBlockPlan& from, std::size_t b, std::int32_t firstPatch,
                const std::vector<R>& geometry);
  void makeNodes(const DeviceBodyInput& input, const DevicePlan& plan);
  void uploadVectors(const NodeVectors& values, DeviceVector<R>& to);
  NodeVectors toMesh(const std::vector<Row4<R>>& rows) const;
  void enqueueForce(typename PatchOperations<R>::Launch PatchOperations<R>::*which, const R* direction, Row4<R>* to);
  void enqueueStep();
  void setStep(double h);
  /// Puts `count` repetitions into the stream, as graphs of `bunch` and of one, which are captured at the first call.
  template <class Enqueue>
  void repeat(std::int64_t count, std::unique_ptr<DeviceGraph> (&graphs)[2], const Enqueue& enqueue) {
    if (!graphs[0]) {
      graphs[0] = std::make_unique<DeviceGraph>(stream, enqueue);
      graphs[1] = std::make_unique<DeviceGraph>(stream, [&] {
        for (std::int64_t i = 0; i < bunch; ++i) enqueue();
      });
    }
    for (; count >= bunch; count -= bunch) graphs[1]->launch(stream);
    for (; count > 0; --count) graphs[0]->launch(stream);
  }

  static constexpr std::int64_t bunch = 20;

  std::int32_t nodeCount = 0;
  std::int64_t elementCount = 0;
  std::int32_t patchCount = 0;
  std::size_t bytes = 0;
  std::vector<std::int32_t> deviceNode;
  std::vector<R> inverseMass;  // by device node
  NodeVectors X;               // reference positions, by mesh node
  DeviceStream stream;
  std::vector<Block> blocks;
  NodeView<R> nodes;
  DeviceVector<Row4<R>> u, slots, result;
  DeviceVector<R> v, external, direction;
  DeviceVector<std::uint8_t> constrained;
  DeviceVector<std::int32_t> slotBegin, slot;
  DeviceVector<double> partial, sum;
  DeviceVector<DeviceClock> clock;
  double h = 0;
  std::unique_ptr<DeviceGraph> stepGraphs[2];
};

}  // namespace ringwatch
