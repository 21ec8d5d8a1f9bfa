#include <ringwatch/app/run/run_certificates.h>

#include <charconv>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/certificate_file.h>

namespace ringwatch {
namespace {

constexpr std::string_view stem = "step_", extension = ".certificate";

/// The step of a certificate's file; empty for other files.
std::optional<std::int64_t> stepOf(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(stem) || !name.ends_with(extension)) return std::nullopt;
  const char *first = name.data() + stem.size(), *last = name.data() + name.size() - extension.size();
  std::int64_t step = 0;
  const auto [end, error] = std::from_chars(first, last, step);
  return error == std::errc() && end == last ? std::optional(step) : std::nullopt;
}

}  // namespace

RunCertificates::RunCertificates(const Scene& scene, const Body& body, std::filesystem::path folder)
    : scene_(scene), body_(body), folder_(std::move(folder)) {
  if (scene_.certificates) requireCertifiable(body_);
}

void RunCertificates::begin(std::int64_t step) {
  std::error_code error;
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error))
    if (const auto of = stepOf(entry.path()); of && (*of >= step || !scene_.certificates)) old.push_back(entry.path());
  for (const std::filesystem::path& file : old) std::filesystem::remove(file, error);
}

void RunCertificates::record(const MonitorReport& report, const State& state, bool violatedBefore) {
  if (!scene_.certificates || !report.fresh) return;
  if (report.verdict == Verdict::violated && !violatedBefore) {
    if (before_) write(before_->step, before_->x);
    write(report.step, state.x);
  } else if (report.step / scene_.every % *scene_.certificates == 0) {
    write(report.step, state.x);
  }
  if (!violatedBefore) before_ = Observed{report.step, state.x};
}

std::int64_t RunCertificates::count() const {
  std::int64_t count = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) count += stepOf(entry.path()) ? 1 : 0;
  return count;
}

void RunCertificates::write(std::int64_t step, const NodeVectors& x) {
  if (step == last_) return;
  std::filesystem::create_directories(folder_);
  try {
    writeFileAtomically(folder_ / fmt::format("{}{:08}{}", stem, step, extension),
                        std::string_view(makeCertificate(body_, x).bytes));
    last_ = step;
  } catch (const NumericalError&) {
    // The tangent is not finite here: the events of the run say so.
  }
}

}  // namespace ringwatch
