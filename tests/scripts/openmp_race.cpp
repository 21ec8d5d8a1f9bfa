// All threads add to the same numbers: the thread sanitizer must report it.
#include <cstdio>
#include <vector>

int main() {
  std::vector<double> sums(16, 0.0);
#pragma omp parallel for schedule(static) num_threads(4)
  for (int i = 0; i < 100000; ++i) sums[i % 16] += 1;
  std::printf("%g\n", sums[0]);
}
