#include <cstdio>

#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/stability_monitor.h>

int main() {
  ringwatch::Body body(ringwatch::loadMesh("bar.msh"), ringwatch::makeMaterial("stvk", 30e3, 0.3, 1000));
  ringwatch::StabilityMonitor monitor(body, {.limit = 2.0});  // largest stable h·omega of your integrator
  ringwatch::NodeVectors x = body.mesh().X, v = ringwatch::NodeVectors::Zero(3, body.nodeCount());
  double time = 0, h = 2e-3;
  for (int step = 0; step < 200; ++step) {
    const ringwatch::MonitorReport& report = monitor.observe(step, time, x, v, h);
    if (!report.bracket) return 1;  // the state is no longer finite, and no step helps
    if (report.verdict == ringwatch::Verdict::violated) {
      std::printf("step %d: h = %g s is proven unstable, %g s is proven stable\n", step, h, report.bracket->safe);
      h = report.bracket->safe;
    }
    x.row(0) *= 1.002;  // here your solver takes its step
    time += h;
  }
}
