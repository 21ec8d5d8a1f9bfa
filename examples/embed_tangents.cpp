// How to embed the monitor in an explicit code of any physics that has element tangents and lumped masses: everything
// in `foreign` is written as foreign code would be. What it needs of ringwatch is between the two marks.
//
//   build/release/bin/ringwatch_embed_tangents
//
// prints a row every 60 steps: step, time, both sides of the bracket (s), and the nodes of the bar that limits them.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <ringwatch/monitor/tangent_bracket.h>

namespace foreign {

/// A net of elastic cables, held along its rim, that a weight in the middle pulls down: bars of two nodes, with the
/// geometric stiffness of their tension.
struct Net {
  int side;
  double rest, stiffness;  // m; N, modulus times section
  std::vector<double> x, v, m;
  std::vector<std::int32_t> bars;
  std::vector<std::uint8_t> held;  // 3 a node
  std::vector<double> tangents;    // 36 a bar

  Net(int n, double spacing, double slack, double EA, double nodeMass) : side(n), rest(slack * spacing), stiffness(EA) {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        x.insert(x.end(), {i * spacing, j * spacing, 0.0});
        m.push_back(nodeMass);
        const bool rim = i == 0 || j == 0 || i == n - 1 || j == n - 1;
        held.insert(held.end(), 3, rim ? 1 : 0);
        if (i + 1 < n) bars.insert(bars.end(), {j * n + i, j * n + i + 1});
        if (j + 1 < n) bars.insert(bars.end(), {j * n + i, (j + 1) * n + i});
      }
    m[n / 2 * n + n / 2] *= 50;
    v.assign(x.size(), 0.0);
    tangents.resize(18 * bars.size());
  }

  /// Forces and tangents of all bars.
  std::vector<double> assemble() {
    std::vector<double> f(x.size(), 0.0);
    for (std::size_t b = 0; b < bars.size() / 2; ++b) {
      const auto i = 3 * static_cast<std::size_t>(bars[2 * b]), j = 3 * static_cast<std::size_t>(bars[2 * b + 1]);
      double d[3], length = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        d[c] = x[j + c] - x[i + c];
        length += d[c] * d[c];
      }
      length = std::sqrt(length);
      const double tension = stiffness * (length / rest - 1);
      for (std::size_t r = 0; r < 3; ++r) {
        f[i + r] += tension * d[r] / length;
        f[j + r] -= tension * d[r] / length;
        for (std::size_t c = 0; c < 3; ++c) {
          const double axial = d[r] * d[c] / (length * length);
          const double k = stiffness / rest * axial + tension / length * ((r == c ? 1 : 0) - axial);
          double* K = tangents.data() + 36 * b;
          K[6 * r + c] = K[6 * (r + 3) + c + 3] = k;
          K[6 * r + c + 3] = K[6 * (r + 3) + c] = -k;
        }
      }
    }
    return f;
  }

  void step(const std::vector<double>& f, double h) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (held[i]) continue;
      v[i] += h * (f[i] / m[i / 3] - (i % 3 == 2 ? 9.81 : 0));
      x[i] += h * v[i];
    }
  }
  double energyOfMotion() const {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += 0.5 * m[i / 3] * v[i] * v[i];
    return sum;
  }
};

}  // namespace foreign

int main() {
  foreign::Net net(21, 0.1, 0.98, 2e3, 0.01);

  // ---- once, before the loop
  ringwatch::TangentBracket bracket(net.m, {{2, net.bars}}, net.held, 1);
  // ----

  double time = 0, first = 0, least = 1;
  std::printf("  step    time (s)    safe (s)  optimistic  of the bar between nodes\n");
  for (int step = 0; step < 600; ++step) {
    const std::vector<double> f = net.assemble();
    // ---- in the loop
    const ringwatch::CriticalStep critical = bracket.evaluate({net.tangents}, 2.0);  // symplectic Euler's limit
    const double h = 0.98 * critical.safe;
    // ----
    if (step == 0) first = critical.safe;
    least = std::min(least, critical.safe / critical.optimistic);
    const auto bar = static_cast<std::size_t>(critical.controlling.element);
    if (step % 60 == 0)
      std::printf("%6d  %10.6f  %10.4e  %10.4e  %d %d\n", step, time, critical.safe, critical.optimistic,
                  net.bars[2 * bar], net.bars[2 * bar + 1]);
    net.step(f, h);
    time += h;
    if (!std::isfinite(net.energyOfMotion()) || critical.safe > critical.optimistic) return 1;
  }
  std::printf("t = %.4f s, energy of motion %.4g J, first safe step %.4e s, narrowest bracket %.1f %%\n", time,
              net.energyOfMotion(), first, 100 * (1 - least));
  return net.energyOfMotion() < 100 ? 0 : 1;
}
