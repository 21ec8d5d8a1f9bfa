#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#include <limits>

#include <ringwatch/app/command/command_line.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/extensions/extensions.h>

namespace ringwatch {

std::span<const StudyInfo> allStudies() { return {}; }
JudgeFunction judgeOfStudies() { return nullptr; }

}  // namespace ringwatch

/// `ringwatch` with what writes the page of a run: takes the same arguments.
int main(int argc, char** argv) {
#if defined(M_MMAP_MAX) && defined(M_TRIM_THRESHOLD)
  // Frames are read one after the other: memory of one that is given back to the system costs a fault a page again.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
  ringwatch::registerExtensions();
  return ringwatch::runCommandLine(argc, argv);
}
