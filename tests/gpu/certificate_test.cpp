#include <cmath>
#include <limits>
#include <string>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/gpu/certificate/device_certificate_impl.h>
#include <ringwatch/gpu/certificate/device_monitor.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <tests/gpu/cases.h>
#include <tests/gpu/checks.h>

using namespace ringwatch;
using checks::expect;
using checks::expectAtMost;
using checks::Test;

namespace {

/// Highest eigenvalue of M⁻¹K over the free degrees of freedom.
double exactHighest(const Body& body, const NodeVectors& x) {
  Eigen::MatrixXd K = body.assembleTangent(x);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double scale = body.constraints().isConstrained(i, c) ? 0.0 : 1 / std::sqrt(body.lumpedMass()[i]);
      K.row(3 * i + c) *= scale;
      K.col(3 * i + c) *= scale;
    }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

void boundAgrees() {
  for (const char* element : elementNames)
    for (const char* law : lawNames) {
      const Body body = loadedBar(element, law, {4, 2, 2});
      const NodeVectors x = randomState(body.mesh(), 0.01, 3);
      DeviceBody<double> device(body);
      device.setPositions(x);
      DeviceCertificate certificate(device);
      NodalBound host(body);
      const std::string what = std::string(element) + " " + law;
      // The CPU keeps its weights in 16 bits.
      for (const int sweeps : {0, 3, 12}) {
        host.reset();
        const double here = certificate.bound(sweeps).value, there = host.evaluate(x, sweeps).value;
        expectAtMost(std::abs(here / there - 1), 5e-4, what + " bound after " + std::to_string(sweeps) + " sweeps");
      }
      const double exact = exactHighest(body, x), bound = certificate.bound().value;
      expectAtMost(exact, bound, what + " bound lies above the exact value");
      expectAtMost(bound, 1.6 * exact, what + " bound is of use");
      expect(!certificate.certify(0.999 * exact), what + " nothing below the exact value is certified");
      expect(certificate.certify(1.1 * bound), what + " what has room is certified");
    }
}

/// A bar that is held at one end, drawn at the other and vibrates, without gravity: so soft a bar would not bear it.
struct Drawn {
  Body body;
  NodeVectors v;
  Drawn(const char* element, const char* law, std::array<int, 3> cells, double noise)
      : body(bar(element, cells), makeMaterial(law, 3e4, 0.3, 1000)), v(randomVectors(body.nodeCount(), noise, 13)) {
    const NodeVectors& X = body.mesh().X;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      if (X(0, i) < 1e-9) body.constraints().fix(i);
      if (X(0, i) > X.row(0).maxCoeff() - 1e-9) body.constraints().move(i, 0, 0.2);
    }
    body.constraints().imposeVelocity(v);
  }
};

/// Runs it step by step, and checks from scratch what the balls say about each step.
void ballsHold(const char* element, const char* law, int steps = 300, std::array<int, 3> cells = {6, 3, 3}) {
  const Drawn drawn(element, law, cells, 0.1);
  DeviceBody<double> device(drawn.body);
  device.setVelocities(drawn.v);
  DeviceCertificate certificate(device);
  const std::string what = std::string(element) + " " + law;
  double sigma = 1.05 * certificate.bound().value;
  expect(certificate.certify(sigma), what + " certified at the start");
  auto& impl = certificate.impl();
  int renewed = 0, lost = 0, certified = 0;
  double excess = -1;
  std::int64_t evaluated = 0;
  for (int k = 0; k < steps; ++k) {
    const double most = impl.verify();  // of all elements, at the state that is about to be checked
    const std::int64_t before = certificate.status().evaluated;
    certificate.step(0.5 * 2 / std::sqrt(sigma));
    const DeviceCertificate::Status status = certificate.status();
    evaluated += status.evaluated - before;
    if (status.certified) {
      ++certified;
      excess = std::max(excess, most);
    } else {
      ++lost;
      expect(most > -1e-9, what + " is lost only where an element exceeds its allowance");
    }
    if (status.certified && !status.nearlyLost) continue;
    ++renewed;
    if (!certificate.renew()) {  // it has stiffened beyond sigma
      sigma = 1.05 * certificate.bound().value;
      if (!certificate.certify(sigma)) break;
    }
  }
  expectAtMost(excess, 1e-9, what + " certified steps keep every element within its allowance");
  expect(device.positions().allFinite(), what + " stays finite");
  expect(certified > 2 * steps / 3, what + " most steps are certified");
  expect(renewed > 0 && evaluated > steps / 3, what + " comes close to its allowances, else this tests nothing");
  std::printf("    %s: %d of %d steps certified, renewed %d times, %lld evaluations\n", what.c_str(), certified, steps,
              renewed, static_cast<long long>(evaluated));
}

/// Evaluations beside the next step lose the certificate at the step at which those of a run step by step lose it, and
/// no later than an element exceeds its allowance by a proof from scratch.
void besideNextStep() {
  constexpr int bunches = 12, steps = 20;
  for (const char* element : {"tet4", "hex8", "wedge6", "pyramid5"}) {
    const Drawn drawn(element, "stvk", {6, 3, 3}, 0.05);
    DeviceBody<double> device(drawn.body), alone(drawn.body);
    device.setVelocities(drawn.v);
    alone.setVelocities(drawn.v);
    DeviceCertificate certificate(device, true), stepByStep(alone, false);
    const std::string what = element;
    int lost = 0, kept = 0;
    for (int bunch = 0; bunch < bunches; ++bunch) {
      // By turns with little and with much room, and each time with weights from scratch.
      const double sigma = (bunch % 2 == 0 ? 1.02 : 2) * certificate.bound().value;
      stepByStep.bound();
      expect(certificate.certify(sigma) && stepByStep.certify(sigma), what + " both certified");
      const double h = 0.5 * 2 / std::sqrt(sigma);
      std::int64_t exceeded = -1;
      for (int k = 0; k < steps; ++k) {
        if (exceeded < 0 && stepByStep.impl().verify() > 1e-9) exceeded = k;
        stepByStep.step(h);
      }
      certificate.step(h, steps);
      const DeviceCertificate::Status found = certificate.status(), expected = stepByStep.status();
      expect(found.checked == steps && expected.checked == steps, what + " every step is checked");
      expect(found.lostAt == expected.lostAt, what + " is lost where a run step by step is");
      expect(exceeded < 0 || (found.lostAt >= 0 && found.lostAt <= exceeded), what + " is lost in time");
      expect(found.evaluated >= expected.evaluated, what + " evaluates what a run step by step does");
      ++(found.lostAt < 0 ? kept : lost);
    }
    expect(device.positions() == alone.positions(), what + " has the same positions");
    expect(lost > 0 && kept > 0, what + " is kept and lost, else this tests nothing");
    std::printf("    %s: kept in %d, lost in %d bunches of steps\n", element, kept, lost);
  }
}

/// Elements that have left their balls are evaluated by warps; all of them then have the values that the pass over all
/// elements, a thread each, found at the same state.
void evaluatesWhatHasLeft() {
  for (const char* element : elementNames)
    for (const char* law : lawNames) {
      const Body body = loadedBar(element, law, {4, 2, 2});
      DeviceBody<double> device(body);
      device.setPositions(randomState(body.mesh(), 0.01, 3));
      DeviceCertificate certificate(device, law == lawNames[0]);  // some with balls that are put in place later
      const std::string what = std::string(element) + " " + law;
      expect(certificate.certify(2 * certificate.bound(6).value), what + " certified");
      auto& impl = certificate.impl();
      double most = 0;
      for (const auto& part : impl.parts)
        for (auto& block : part->blocks) {
          const std::vector<double> expected = block.value.download();
          constexpr std::uint32_t minusOnes = 0xbc00bc00;  // two numbers in half precision: of radii, always left
          block.balls.upload(std::vector<std::uint32_t>(block.balls.size(), minusOnes));
          if (block.centres.size() > 0)
            block.centres.upload(std::vector<std::uint32_t>(block.centres.size(), minusOnes));
          block.value.upload(std::vector<double>(expected.size(), -1));
          certificate.step(1e-9);
          certificate.status();  // waits for the step
          const std::vector<double> found = block.value.download();
          for (std::size_t place = 0; place < expected.size(); ++place)
            if (expected[place] > 0) most = std::max(most, std::abs(found[place] / expected[place] - 1));
        }
      const DeviceCertificate::Status status = certificate.status();
      expect(status.evaluated == static_cast<std::int64_t>(body.mesh().elementCount()), what + " all are evaluated");
      expect(status.certified, what + " stays certified");
      expectAtMost(most, 3e-15, what + " has the values of the pass over all elements");
    }
}

void fewAreEvaluated() {
  const Drawn drawn("tet4", "stvk", {16, 8, 8}, 0.02);
  DeviceBody<double> device(drawn.body);
  device.setVelocities(drawn.v);
  DeviceCertificate certificate(device);
  const double sigma = 1.5 * certificate.bound().value, h = 2 / std::sqrt(sigma);
  expect(certificate.certify(sigma), "certified at the start");
  certificate.step(h, 50);
  const DeviceCertificate::Status status = certificate.status();
  expect(status.certified, "a slow run stays certified");
  expect(status.checked == 50, "every step is checked");
  expectAtMost(static_cast<double>(status.evaluated), 0.05 * 50 * static_cast<double>(device.elementCount()),
               "few elements are evaluated");
  DeviceBody<double> plain(drawn.body);
  plain.setVelocities(drawn.v);
  plain.step(h, 50);
  expectAtMost((plain.positions() - device.positions()).norm() / plain.positions().norm(), 1e-13,
               "checked steps lead where others lead");
}

void mixedBlocks() {
  BarOptions options;
  options.cells = {8, 3, 3};
  options.size = {2, 0.75, 0.75};
  const Body body(generateMixedBar(options), makeMaterial("neo-hookean", 3e4, 0.3, 1000));
  DeviceBody<double> device(body);
  device.setVelocities(randomVectors(body.nodeCount(), 0.02, 13));
  DeviceCertificate certificate(device);
  NodalBound host(body);
  const double bound = certificate.bound(6).value;
  expectAtMost(std::abs(bound / host.evaluate(body.mesh().X, 6).value - 1), 5e-4, "bound of a mixed mesh");
  expect(certificate.certify(1.3 * bound), "certified");
  certificate.step(1 / std::sqrt(bound), 25);
  expect(certificate.status().checked == 25, "all blocks together check a step once");
  expect(certificate.status().certified, "stays certified");
}

void losesWhatItMust() {
  const Body body = loadedBar("tet4", "stvk");
  DeviceBody<double> device(body);
  DeviceCertificate certificate(device);
  const double sigma = 1.2 * certificate.bound().value, h = 1 / std::sqrt(sigma);
  expect(certificate.certify(sigma), "certified at rest");
  NodeVectors x = body.mesh().X;
  device.setPositions(1.5 * x);  // far stiffer
  certificate.step(h, 3);
  expect(!certificate.status().certified && certificate.status().lostAt == 0, "a jump is lost at once");
  expect(!certificate.renew(), "and cannot be certified");
  device.setPositions(x);
  device.setVelocities(NodeVectors::Zero(3, x.cols()));
  expect(certificate.renew(), "at rest it is again");
  x(0, 3) = std::numeric_limits<double>::quiet_NaN();
  device.setPositions(x);
  certificate.step(h);
  expect(!certificate.status().certified, "what is not a number is not certified");
  expect(!certificate.renew(), "nor later");
  expect(std::isnan(certificate.bound().value), "and has no bound");
  checks::expectThrows<InputError>([&] { certificate.certify(0); }, "must be > 0");
}

/// A DeviceMonitor at positions that lie on the device in the order of the mesh.
void statesOfOthers() {
  for (const char* element : elementNames) {
    const Drawn drawn(element, "stvk", {4, 2, 2}, 0.1);
    const Body& body = drawn.body;
    const std::string what = std::string(element) + ", a state of another program: ";
    DeviceMonitor monitor(body, 2);
    const auto observe = [&](const NodeVectors& x, std::optional<double> h) {
      const DeviceVector<double> lies(std::span<const double>(x.data(), static_cast<std::size_t>(x.size())));
      return monitor.observe(lies.data(), h);
    };
    const double exact = 2 / std::sqrt(exactHighest(body, body.mesh().X)), safe = observe(body.mesh().X, {}).safe;
    expectAtMost(safe, exact, what + "what is proven lies below the critical step");
    expectAtMost(exact, 1.3 * safe, what + "it is of use");
    const double h = 0.9 * safe;
    expect(observe(body.mesh().X, h).renewed, what + "the first certificate is made");
    int kept = 0, certified = 0;
    for (int k = 0; k <= 40; ++k) {
      NodeVectors x = body.mesh().X;
      x.row(0) *= 1 + 0.01 * k;
      const DeviceMonitor::Report report = observe(x, h);
      kept += !report.renewed;
      certified += report.certified;
      if (report.certified) expectAtMost(h, 2 / std::sqrt(exactHighest(body, x)), what + "a certified step is stable");
    }
    expect(kept > 0 && certified > kept && certified <= 40, what + "some keep it, some renew it, the last are refused");
    NodeVectors x = body.mesh().X;
    x(0, 0) = std::numeric_limits<double>::quiet_NaN();
    const DeviceMonitor::Report none = observe(x, h);
    expect(!none.certified && none.safe == 0, what + "what is not a number is not certified");
    expect(observe(body.mesh().X, h).certified, what + "a good state is, after it");
    checks::expectThrows<InputError>([&] { monitor.observe(x.data(), h); }, "not in the memory of GPU");
    checks::expectThrows<InputError>([&] { observe(x, 0); }, "must be > 0");
  }
}

const Test tests[] = {
    {"certificate-bound", true, boundAgrees},
    {"certificate-balls-tet4", true,
     [] {
       for (const char* law : lawNames)
         if (law != std::string("linear")) ballsHold("tet4", law);  // the tangent of "linear" never changes
     }},
    {"certificate-balls-others", true,
     [] {
       for (const char* element : {"hex8", "wedge6", "pyramid5"}) ballsHold(element, "stvk");
     }},
    {"certificate-beside-next-step", true, besideNextStep},
    // Short enough for the sanitizers of the CUDA Toolkit, which are a thousand times slower.
    {"certificate-small-balls", true,
     [] {
       for (const char* element : elementNames) ballsHold(element, "stvk", 60, {3, 2, 2});
     }},
    {"certificate-refresh", true, evaluatesWhatHasLeft},
    {"certificate-few", true, fewAreEvaluated},
    {"certificate-mixed", true, mixedBlocks},
    {"certificate-loses", true, losesWhatItMust},
    {"certificate-others", true, statesOfOthers},
};

}  // namespace
