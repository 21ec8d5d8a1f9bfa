#pragma once
#include <array>
#include <string_view>

namespace ringwatch {

/// Exit statuses of the program.
enum class ExitStatus : int { done = 0, unstable = 1, badInput = 2, notCertified = 3, interrupted = 4 };

struct ExitStatusInfo {
  ExitStatus status;
  std::string_view meaning;  // one line
};

/// The one table of exit statuses: help texts print it, and a test holds the documents to it.
inline constexpr std::array<ExitStatusInfo, 5> exitStatuses{{
    {ExitStatus::done, "done, stable"},
    {ExitStatus::unstable, "instability found, a verification failed, no convergence, or an error ended a run"},
    {ExitStatus::badInput, "bad usage or bad input; one line on standard error says what and where"},
    {ExitStatus::notCertified,
     "done, no instability seen, but nothing certified the run or the step that was to be proven"},
    {ExitStatus::interrupted, "interrupted by a signal, no instability found; results up to there are kept"},
}};

}  // namespace ringwatch
