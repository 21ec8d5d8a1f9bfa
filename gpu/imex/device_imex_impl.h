#pragma once
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/imex/device_imex.h>
#include <ringwatch/gpu/imex/imex_plan.h>
#include <ringwatch/gpu/imex/tangent_operations.h>

namespace ringwatch {

struct DeviceImex::Impl {
  struct Block {
    TangentOperations operations;
    ImexElementsView view;
    DeviceVector<std::int32_t> place, node, cluster;
    DeviceVector<double> shape, rest, restHighest, rotation;
  };
  /// A stream beside the body's, and the points at which they meet.
  struct Side {
    DeviceStream stream;
    DeviceEvent forked, joined;
  };

  Impl(DeviceBody<double>& deviceBody, const Mesh& mesh, const std::vector<std::vector<ElementRef>>& clusters, double h,
       const DeviceImexOptions& options);
  void makeBlocks(const ImexPlan& plan);
  void upload(const ImexPlan& plan, const ImexTeams& who);
  /// What the kernels see, of what is on the device.
  void makeView(const ImexPlan& plan, const ImexTeams& who, const DeviceImexOptions& options, double h);
  void enqueueStep();
  /// Keeps the state, or puts it back.
  void copyState(bool back);
  void run(std::int64_t count) {
    body.repeat(count, graphs, [this](std::int64_t steps) {
      for (; steps > 0; --steps) enqueueStep();
    });
  }

  DeviceBody<double>::Impl& whole;
  DevicePart<double>& body;  // all of it
  std::size_t bytes = 0;
  std::vector<ElementRef> firstElement;  // of each cluster
  std::vector<std::size_t> clusterSize;  // elements
  std::vector<Block> blocks;
  ImexView view;
  DeviceVector<std::int32_t> node, column, rowBegin, teamOfBlock, ofBlocks, ofWarps;
  DeviceVector<std::int32_t> slice, first;
  DeviceVector<ImexContribution> contributions;
  DeviceVector<double> lanes, value, preconditioner, rotated, partial;
  DeviceVector<ImexCluster> clusters;
  DeviceVector<ImexTeam> teams;
  DeviceVector<unsigned long long> arrived;
  DeviceVector<ImexStatus> status;
  // The state at the last status, kept at the first step after it.
  DeviceVector<Row4<double>> keptU;
  DeviceVector<double> keptV;
  std::int64_t keptStep = 0, asked = 0;
  bool kept = false;
  Side side;
  std::unique_ptr<DeviceGraph> graphs[2];
};

}  // namespace ringwatch
