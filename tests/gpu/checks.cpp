#include <tests/gpu/checks.h>

#include <cstdio>
#include <exception>
#include <utility>
#include <vector>

namespace checks {
namespace {
struct Entry {
  std::string name;
  bool needsDevice;
  std::function<void()> body;
};
std::vector<Entry>& entries() {
  static std::vector<Entry> all;
  return all;
}
int failures = 0, checked = 0;
double closest = 0;
}  // namespace

Test::Test(std::string name, bool needsDevice, std::function<void()> body) {
  entries().push_back({std::move(name), needsDevice, std::move(body)});
}
void fail(const std::string& text) {
  ++failures;
  std::printf("    FAILED: %s\n", text.c_str());
}
void expect(bool holds, const std::string& text) {
  ++checked;
  if (!holds) fail(text);
}
void expectAtMost(double value, double bound, const std::string& text) {
  ++checked;
  if (!(value <= bound)) fail(text + ": " + std::to_string(value / bound) + " of the bound " + std::to_string(bound));
  if (value / bound > closest) closest = value / bound;
}

int run(std::string_view filter, bool haveDevice) {
  int failed = 0, passed = 0, skipped = 0;
  for (const Entry& entry : entries()) {
    if (entry.name.find(filter) == std::string::npos) continue;
    if (entry.needsDevice && !haveDevice) {
      ++skipped;
      continue;
    }
    failures = checked = 0;
    closest = 0;
    try {
      entry.body();
    } catch (const std::exception& error) {
      fail(std::string("threw: ") + error.what());
    }
    if (checked == 0) fail("checked nothing");
    std::printf("%s %s (%d checks, largest error %.2g of its bound)\n", failures ? "FAILED" : "ok    ",
                entry.name.c_str(), checked, closest);
    std::fflush(stdout);
    (failures ? failed : passed) += 1;
  }
  std::printf("%d passed, %d failed, %d skipped for want of a GPU\n", passed, failed, skipped);
  if (failed || passed + skipped == 0) return 1;
  return skipped ? 77 : 0;
}

}  // namespace checks
