#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/report/run_analysis.h>
#include <ringwatch/app/report/run_history.h>

namespace ringwatch {

/// What the page says first. Every sentence is about what the run wrote.
struct PageVerdict {
  enum class Tone { good, unsure, bad };
  Tone tone = Tone::unsure;
  std::string title;                  // "Unstable"
  std::string sentence;               // which element, what is wrong with it, when
  std::size_t lead = 0;               // the part of it that says so; the rest is what followed. 0: all of it
  std::vector<std::string> remedies;  // what to do, one sentence each

  std::string leadText() const { return lead > 0 ? sentence.substr(0, lead) : sentence; }
};

/// The smallest safe step of a history's rows before a time (s), and where it was.
struct SmallestSafe {
  double safe = 0, time = 0;  // s
  double step = 0;            // number of the step
  std::string element;        // "block:element", "" for unknown
};
/// Empty where the history has no positive safe step there.
std::optional<SmallestSafe> smallestSafe(const RunHistory& history, std::optional<double> before = {});

/// A step rounded to four digits, down or up, so that what is proven below or above the step holds for the text.
std::string stepRoundedDown(double step);
std::string stepRoundedUp(double step);

/// Whether springs or contact, not the elements, hold most of the mode that proves the first step too large. summary:
/// of summary.json, or null without one.
bool discreteGoverns(const nlohmann::ordered_json& summary);

/// summary: of summary.json, or null without one; history: empty without one; analysis: of the frame that the page is
/// about, nullptr without one.
PageVerdict verdictOf(const nlohmann::ordered_json& summary, const std::optional<RunHistory>& history,
                      const RunAnalysis* analysis = nullptr);

/// What would make a step possible that is not proven: handlers by what they gain, mass, other elements.
std::vector<std::string> remediesFor(const WhatIf& row, const RunAnalysis& analysis);
/// What is to be had above the safe step, from a table of steps; empty for nothing.
std::vector<std::string> largerSteps(const RunAnalysis& analysis);

/// "element 1357 of the mesh file (tet4, 0:1357)", of an element of summary.json; "" for null.
std::string elementName(const nlohmann::ordered_json& element);

}  // namespace ringwatch
