#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/certificate/device_certificate.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/gpu/imex/device_imex.h>
#include <tests/gpu/cases.h>
#include <tests/gpu/checks.h>

using namespace ringwatch;
using checks::expect;
using checks::Test;

/// Bodies on several devices, against the same on one: to the last bit.
namespace {

/// Several parts on one GPU; where there are more GPUs, on these too.
std::vector<std::vector<int>> deviceLists() {
  std::vector<std::vector<int>> lists{{0, 0}, {0, 0, 0}, {0, 0, 0, 0}};
  if (deviceCount() > 1) {
    lists.push_back({0, 1});
    lists.push_back({1, 0, 1});
    lists.push_back({1});
  }
  if (deviceCount() > 3) lists.push_back({0, 1, 2, 3});
  return lists;
}
std::string nameOf(const std::vector<int>& devices) {
  std::string name = "devices";
  for (const int device : devices) name += " " + std::to_string(device);
  return name;
}

std::string nameOf(const Body& body) {
  return body.mesh().blocks.size() > 1 ? "mixed" : std::string(elementInfo(body.mesh().blocks.front().type).name);
}

template <class R>
void sameForces() {
  std::vector<Body> bodies;
  for (const char* element : elementNames) bodies.push_back(loadedBar(element, "neo-hookean", {16, 6, 6}));
  bodies.emplace_back(mixedBar(), makeMaterial("stvk", 3e4, 0.3, 1000));
  for (const Body& body : bodies) {
    const NodeVectors x = randomState(body.mesh(), 0.01, 3), p = randomVectors(x.cols(), 1, 7);
    DeviceBody<R> one(body);
    one.setPositions(x);
    one.setVelocities(p);
    const NodeVectors f = one.internalForce(), Kp = one.tangentProduct(p);
    for (const std::vector<int>& devices : deviceLists()) {
      const std::string what = nameOf(body) + ", " + nameOf(devices);
      DeviceBody<R> many(body, devices);
      expect(many.devices() == devices, what + ": parts are where they are wanted");
      many.impl().forEachPart([](auto& part) {
        part.slots.fill(0xff);
        part.result.fill(0xff);
        part.partial.fill(0xff);
      });
      many.setPositions(x);
      many.setVelocities(p);
      expect(sameBits(many.positions(), one.positions()), what + ": positions come back");
      expect(sameBits(many.velocities(), one.velocities()), what + ": velocities come back");
      for (int repeat = 0; repeat < 3; ++repeat) {
        expect(sameBits(many.internalForce(), f), what + ": force");
        expect(sameBits(many.tangentProduct(p), Kp), what + ": tangent product");
      }
      expect(many.strainEnergy() == one.strainEnergy(), what + ": strain energy");
      expect(many.kineticEnergy() == one.kineticEnergy(), what + ": kinetic energy");
      expect(many.bytesExchanged() > 0 || devices.size() == 1, what + ": something is exchanged");
    }
  }
}

template <class R>
void sameRuns() {
  for (const char* element : {"tet4", "hex8"}) {
    const Body body = loadedBar(element, "stvk", {16, 6, 6});
    const NodeVectors start = randomState(body.mesh(), 0.01, 11);
    const auto run = [&](const std::vector<int>& devices) {
      DeviceBody<R> device(body, devices);
      device.setPositions(start);
      device.step(2e-4, 137);
      device.step(1e-4);
      device.step(1e-4, 20);
      expect(device.steps() == 158, "steps are counted");
      return std::pair(device.positions(), device.velocities());
    };
    const auto [x, v] = run({});
    expect(x.allFinite(), "the run stays finite");
    for (const std::vector<int>& devices : deviceLists())
      for (int repeat = 0; repeat < 3; ++repeat) {
        const auto [x2, v2] = run(devices);
        expect(sameBits(x2, x) && sameBits(v2, v), std::string(element) + ", " + nameOf(devices) + ": a run");
      }
  }
}

/// A run with a certificate that is renewed where it must be, and what it said on the way.
struct Watched {
  std::vector<double> bounds;
  std::vector<std::int64_t> said;
  NodeVectors x;
  Watched(const Body& body, const NodeVectors& v, const std::vector<int>& devices) {
    DeviceBody<double> device(body, devices);
    device.setVelocities(v);
    DeviceCertificate certificate(device);
    for (const int sweeps : {0, 3, 12}) bounds.push_back(certificate.bound(sweeps).value);
    double sigma = 1.05 * bounds.back();
    said.push_back(certificate.certify(0.9 * bounds.back() / 1.6));
    said.push_back(certificate.certify(sigma));
    for (int k = 0; k < 60; ++k) {
      certificate.step(0.5 * 2 / std::sqrt(sigma), 1 + k % 4);
      const DeviceCertificate::Status status = certificate.status();
      said.insert(said.end(), {status.certified, status.lostAt, status.checked, status.evaluated, status.nearlyLost});
      if (status.certified && !status.nearlyLost) continue;
      said.push_back(certificate.renew());
      if (said.back()) continue;
      bounds.push_back(certificate.bound().value);
      sigma = 1.05 * bounds.back();
      said.push_back(certificate.certify(sigma));
    }
    x = device.positions();
    device.setPositions(1.5 * body.mesh().X);
    certificate.step(1e-6, 2);
    said.push_back(certificate.status().lostAt);
    NodeVectors bad = body.mesh().X;
    bad(0, bad.cols() - 1) = std::numeric_limits<double>::quiet_NaN();
    device.setPositions(bad);
    said.push_back(std::isnan(certificate.bound().value));
  }
};

void sameCertificates() {
  std::size_t most = 0;
  std::vector<Body> bodies;
  for (const char* element : {"tet4", "hex8"})
    bodies.emplace_back(bar(element, {16, 6, 6}), makeMaterial("stvk", 3e4, 0.3, 1000));
  bodies.emplace_back(mixedBar(), makeMaterial("neo-hookean", 3e4, 0.3, 1000));
  for (Body& body : bodies) {
    NodeVectors v = randomVectors(body.nodeCount(), 0.2, 13);
    const NodeVectors& X = body.mesh().X;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      if (X(0, i) < 1e-9) body.constraints().fix(i);
      if (X(0, i) > X.row(0).maxCoeff() - 1e-9) body.constraints().move(i, 0, 0.2);
    }
    body.constraints().imposeVelocity(v);
    const Watched one(body, v, {});
    expect(one.said[1] == 1, "certified at the start");
    most = std::max(most, one.said.size());
    for (const std::vector<int>& devices : deviceLists()) {
      const std::string what = nameOf(body) + ", " + nameOf(devices);
      const Watched many(body, v, devices);
      expect(many.bounds == one.bounds, what + ": bounds");
      expect(many.said == one.said, what + ": what the certificate says of every step");
      expect(sameBits(many.x, one.x), what + ": positions");
    }
  }
  expect(most > 2 + 5 * 60 + 2, "some are renewed on the way");
}

void refusesParts() {
  const Body body(bar("tet4", {8, 6, 6}), makeMaterial("stvk", 3e4, 0.3, 1000));
  DeviceBody<double> two(body, {0, 0});
  checks::expectThrows<InputError>([&] { DeviceImex imex(two, body.mesh(), {{{0, 0}}}, 1e-4); }, "imex on 2 GPUs");
  checks::expectThrows<InputError>([&] { DeviceBody<double>(body, {0, 99}); }, "GPU 99: this machine has");
  checks::expectThrows<InputError>([&] { DeviceBody<double>(body, {-1}); }, "GPU -1: this machine has");
  const Mesh small = bar("tet4", {2, 2, 2});
  DeviceBody<double> one(Body(small, makeMaterial("stvk", 3e4, 0.3, 1000)), {0, 0, 0});
  expect(one.devices() == std::vector<int>{0}, "a single patch is on a single device");
}

const Test tests[] = {
    {"devices-forces-double", true, sameForces<double>}, {"devices-forces-float", true, sameForces<float>},
    {"devices-runs-double", true, sameRuns<double>},     {"devices-runs-float", true, sameRuns<float>},
    {"devices-certificates", true, sameCertificates},    {"devices-refuses", true, refusesParts},
};

}  // namespace
