#pragma once
#include "program.h"

namespace ringwatch::test {

/// A bar with slivers, swinging under its weight at three times its critical step.
class HandledProgram : public Program {
 protected:
  void SetUp() override;
  void write(const std::string& handler, const std::string& rest = "", const std::string& monitor = "");
  static std::string number(double value);

  double critical_ = 0, step_ = 0;  // s
};

}  // namespace ringwatch::test
