// How to embed the monitor in an explicit code that has positions and tetrahedra: everything in `foreign` is written as
// foreign code would be, with arrays and a loop of its own. What it needs of ringwatch is between the two
// marks.
//
//   build/release/bin/ringwatch_embed_positions
//
// prints a row every 100 steps: step, time, the step that was taken, and both sides of the bracket; s.
#include <cmath>
#include <cstdio>
#include <vector>

#include <ringwatch/monitor/stability_monitor.h>

namespace foreign {

/// A cantilever of neo-Hookean tetrahedra that hangs under its weight, with a force loop of its own.
struct Solver {
  std::vector<double> X, x, v, f, m;  // 3 a node; m 1 a node
  std::vector<int> tets;              // 4 a tetrahedron, the first three anticlockwise when seen from the fourth
  std::vector<double> inverse;        // 9 a tetrahedron: the inverse of its edges at rest, and its volume
  std::vector<double> volume;
  double mu, lambda, density;

  Solver(int nx, int ny, int nz, double edge, double young, double nu, double rho)
      : mu(young / (2 * (1 + nu))), lambda(young * nu / ((1 + nu) * (1 - 2 * nu))), density(rho) {
    auto node = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) X.insert(X.end(), {i * edge, j * edge, k * edge});
    const int path[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};  // Kuhn's six around the diagonal 0-7
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          for (auto [a, b] : path) {
            auto corner = [&](int c) { return node(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)); };
            tets.insert(tets.end(), {corner(0), corner(a), corner(b), corner(7)});
          }
    x = X;
    v.assign(X.size(), 0.0);
    m.assign(X.size() / 3, 0.0);
    for (std::size_t e = 0; e < tets.size() / 4; ++e) {
      double D[9];
      edges(X, e, D);
      const double det = determinant(D);
      volume.push_back(det / 6);
      const int n[3] = {1, 2, 0};
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          inverse.push_back(
              (D[3 * n[c] + n[r]] * D[3 * n[n[c]] + n[n[r]]] - D[3 * n[c] + n[n[r]]] * D[3 * n[n[c]] + n[r]]) / det);
      for (int a = 0; a < 4; ++a) m[tets[4 * e + a]] += density * det / 24;
    }
  }

  /// One step of symplectic Euler under gravity; nodes with X = 0 are held.
  void step(double h) {
    f.assign(x.size(), 0.0);
    for (std::size_t e = 0; e < tets.size() / 4; ++e) {
      double D[9], F[9] = {}, P[9], cofactor[9];
      edges(x, e, D);
      const double* B = inverse.data() + 9 * e;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          for (int k = 0; k < 3; ++k) F[3 * r + c] += D[3 * r + k] * B[3 * k + c];
      const int n[3] = {1, 2, 0};
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          cofactor[3 * r + c] =
              F[3 * n[r] + n[c]] * F[3 * n[n[r]] + n[n[c]]] - F[3 * n[r] + n[n[c]]] * F[3 * n[n[r]] + n[c]];
      const double J = determinant(F), p = (lambda * std::log(J) - mu) / J;
      for (int i = 0; i < 9; ++i) P[i] = mu * F[i] + p * cofactor[i];
      for (int a = 1; a < 4; ++a)
        for (int r = 0; r < 3; ++r) {
          double force = 0;
          for (int c = 0; c < 3; ++c) force += volume[e] * P[3 * r + c] * B[3 * (a - 1) + c];
          f[3 * static_cast<std::size_t>(tets[4 * e + static_cast<std::size_t>(a)]) + static_cast<std::size_t>(r)] -=
              force;
          f[3 * static_cast<std::size_t>(tets[4 * e]) + static_cast<std::size_t>(r)] += force;
        }
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double gravity = i % 3 == 2 ? -9.81 : 0;
      v[i] = X[i - i % 3] < 1e-12 ? 0 : v[i] + h * (f[i] / m[i / 3] + gravity);
      x[i] += h * v[i];
    }
  }

  void edges(const std::vector<double>& at, std::size_t e, double* D) const {
    for (std::size_t a = 1; a < 4; ++a)
      for (std::size_t r = 0; r < 3; ++r)
        D[3 * r + a - 1] =
            at[3 * static_cast<std::size_t>(tets[4 * e + a]) + r] - at[3 * static_cast<std::size_t>(tets[4 * e]) + r];
  }
  static double determinant(const double* A) {
    return A[0] * (A[4] * A[8] - A[5] * A[7]) - A[1] * (A[3] * A[8] - A[5] * A[6]) + A[2] * (A[3] * A[7] - A[4] * A[6]);
  }
};

}  // namespace foreign

int main() {
  foreign::Solver solver(10, 2, 2, 0.02, 2e5, 0.3, 1000);
  const auto nodes = static_cast<Eigen::Index>(solver.X.size() / 3);

  // ---- once, before the loop
  ringwatch::Mesh mesh;
  mesh.X = Eigen::Map<const ringwatch::NodeVectors>(solver.X.data(), 3, nodes);
  mesh.blocks = {{ringwatch::elementTypeOf<ringwatch::Tet4>, {solver.tets.begin(), solver.tets.end()}, {}}};
  ringwatch::BodyOptions small;
  small.threads = 1;
  ringwatch::Body body(mesh, ringwatch::makeMaterial("neo-hookean", 2e5, 0.3, 1000), small);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (mesh.X(0, i) < 1e-12) body.constraints().fix(i);
  ringwatch::MonitorOptions options;
  options.limit = 2.0;  // symplectic Euler's
  ringwatch::StabilityMonitor monitor(body, options);
  // ----

  double time = 0;
  std::printf("  step    time (s)       h (s)    safe (s)  optimistic\n");
  for (int step = 0; step < 1000; ++step) {
    // ---- in the loop
    const ringwatch::MonitorReport& report =
        monitor.observe(step, time, Eigen::Map<const ringwatch::NodeVectors>(solver.x.data(), 3, nodes),
                        Eigen::Map<const ringwatch::NodeVectors>(solver.v.data(), 3, nodes), std::nullopt);
    if (!report.bracket) break;  // the state is not finite: no step helps
    const double h = 0.98 * report.bracket->safe;
    // ----
    if (step % 100 == 0)
      std::printf("%6d  %10.6f  %10.4e  %10.4e  %10.4e\n", step, time, h, report.bracket->safe,
                  report.bracket->optimistic);
    solver.step(h);
    time += h;
  }
  double lowest = 0;
  for (std::size_t i = 0; i < solver.x.size(); i += 3) lowest = std::min(lowest, solver.x[i + 2]);
  std::printf("t = %.4f s, the lowest node is at z = %.4f m\n", time, lowest);
  for (const ringwatch::MonitorEvent& event : monitor.events())
    std::printf("%s\n", ringwatch::eventText(event, body.mesh()).c_str());
  return std::isfinite(lowest) && lowest > -0.2 && monitor.events().empty() ? 0 : 1;
}
