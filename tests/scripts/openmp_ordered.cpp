// Threads hand data to each other through the barriers, critical sections and reductions of OpenMP alone: the thread
// sanitizer must stay silent.
#include <cstdio>
#include <vector>

int main() {
  const int n = 10000;
  std::vector<double> a(n, 1.0), b(a);
  double sum = 0;
  auto at = [](std::vector<double>& v, int i) -> double& { return v[i]; };
  for (int round = 0; round < 20; ++round) {
#pragma omp parallel for schedule(static) num_threads(4)
    for (int i = 0; i < n; ++i) at(b, i) = 0.5 * at(a, n - 1 - i);
#pragma omp parallel num_threads(4)
    {
#pragma omp for schedule(dynamic, 64)
      for (int i = 0; i < n; ++i) at(a, n - 1 - i) = at(b, i) + 1;
#pragma omp for reduction(+ : sum)
      for (int i = 0; i < n; ++i) sum += at(a, i);
#pragma omp single
      sum += at(a, 0);
#pragma omp critical
      sum += 1;
    }
  }
  std::printf("%g\n", sum);
}
