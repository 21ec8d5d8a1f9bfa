#pragma once
#include <functional>
#include <string>
#include <string_view>

/// What the GPU's tests need of a test framework; a bare GPU machine has none.
namespace checks {

/// Registers a test; needsDevice: it is skipped without a GPU.
struct Test {
  Test(std::string name, bool needsDevice, std::function<void()> body);
};
/// Notes a failure of the running test.
void fail(const std::string& text);
/// Fails unless it holds.
void expect(bool holds, const std::string& text);
/// Fails unless value <= bound; NaN fails. Remembers the largest share of the bound, which the summary prints.
void expectAtMost(double value, double bound, const std::string& text);
/// Fails unless call throws an Error whose text contains `part`.
template <class Error, class Call>
void expectThrows(const Call& call, std::string_view part) {
  try {
    call();
  } catch (const Error& error) {
    expect(std::string_view(error.what()).find(part) != std::string_view::npos,
           std::string("error text: ") + error.what());
    return;
  }
  fail("did not throw: " + std::string(part));
}
/// Runs the tests whose names contain `filter`; the program's exit status: 0, 1 after a failure, 77 when some were
/// skipped.
int run(std::string_view filter, bool haveDevice);

}  // namespace checks
