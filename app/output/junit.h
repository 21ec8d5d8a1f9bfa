#pragma once
#include <string>
#include <vector>

namespace ringwatch {

/// A test case of JUnit's XML. It failed or was skipped where a message says so.
struct JunitCase {
  std::string name, failure = {}, skipped = {};
  std::string output = {};  ///< what it printed
};

/// A test suite in the XML of JUnit, as Jenkins, GitLab and GitHub's actions read it. className: of all cases; output:
/// of the suite.
std::string junitText(const std::string& suite, const std::string& className, const std::vector<JunitCase>& cases,
                      const std::string& output = {});

}  // namespace ringwatch
