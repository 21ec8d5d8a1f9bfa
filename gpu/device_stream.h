#pragma once
#include <cuda_runtime_api.h>

#include <ringwatch/gpu/cuda_error.h>

namespace ringwatch {

/// Makes a device the current one of this thread until the end of the scope.
class OnDevice {
 public:
  explicit OnDevice(int device) {
    checkCuda(cudaGetDevice(&before_), "cudaGetDevice");
    if (device != before_) checkCuda(cudaSetDevice(device), "cudaSetDevice");
  }
  ~OnDevice() { cudaSetDevice(before_); }
  OnDevice(const OnDevice&) = delete;
  OnDevice& operator=(const OnDevice&) = delete;

 private:
  int before_ = 0;
};

/// A stream of the current device that destroys itself.
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

/// A point in a stream of the device that was current when it was made, for others to wait for.
class DeviceEvent {
 public:
  DeviceEvent() { checkCuda(cudaEventCreateWithFlags(&event_, cudaEventDisableTiming), "cudaEventCreate"); }
  ~DeviceEvent() { cudaEventDestroy(event_); }
  DeviceEvent(const DeviceEvent&) = delete;
  DeviceEvent& operator=(const DeviceEvent&) = delete;
  /// Stands for all that is in the stream by now.
  void record(cudaStream_t stream) { checkCuda(cudaEventRecord(event_, stream), "cudaEventRecord"); }
  /// Has what comes into the stream from now on wait for it, on any device. An event that was never recorded is past.
  void holdUp(cudaStream_t stream) const { checkCuda(cudaStreamWaitEvent(stream, event_, 0), "cudaStreamWaitEvent"); }

 private:
  cudaEvent_t event_ = nullptr;
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

}  // namespace ringwatch
