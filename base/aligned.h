#pragma once
#include <cstddef>
#include <vector>

namespace ringwatch {

/// Memory on cache-line borders, so that packs load without splitting lines. Of large arrays the system is asked for
/// huge pages, which it grants by its setting transparent_hugepage (Linux): a pass that streams through 64 MB of
/// element data misses the translation of fewer addresses then. Throws std::bad_alloc.
void* allocateAligned(std::size_t bytes);
void deallocateAligned(void* memory, std::size_t bytes);

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocateAligned(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { deallocateAligned(p, n * sizeof(T)); }
  template <class U>
  bool operator==(const AlignedAllocator<U>&) const {
    return true;
  }
};
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace ringwatch
