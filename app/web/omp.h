#pragma once
// Stands in for OpenMP: the page has one thread.
inline int omp_get_max_threads() { return 1; }
inline int omp_get_thread_num() { return 0; }
