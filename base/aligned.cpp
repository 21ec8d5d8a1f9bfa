#include <ringwatch/base/aligned.h>

#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace ringwatch {
namespace {

constexpr std::size_t cacheLine = 64;
/// Of x86-64 and of most other systems; arrays that have at least two of them are large.
constexpr std::size_t hugePage = std::size_t{2} << 20, large = 2 * hugePage;

std::align_val_t alignmentOf(std::size_t bytes) { return std::align_val_t{bytes >= large ? hugePage : cacheLine}; }

}  // namespace

void* allocateAligned(std::size_t bytes) {
  void* const memory = ::operator new(bytes, alignmentOf(bytes));
#if defined(__linux__)
  // What the system does not grant costs nothing but time.
  if (bytes >= large) static_cast<void>(madvise(memory, bytes / hugePage * hugePage, MADV_HUGEPAGE));
#endif
  return memory;
}

void deallocateAligned(void* memory, std::size_t bytes) { ::operator delete(memory, alignmentOf(bytes)); }

}  // namespace ringwatch
