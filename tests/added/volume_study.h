#pragma once
#include <ringwatch/app/command/verify.h>
#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators/generators.h>

namespace ringwatch::test {

/// A study added from outside: the volume of a bar of every law.
inline StudyReport verifyVolume(StudyEffort) {
  StudyReport report;
  report.study = "bar-volume";
  for (const LawInfo& law : allLaws())
    checkNear(report, "volume with " + std::string(law.name),
              Body(generateBar(BarOptions{}), makeMaterial(law.name, 30e3, 0.3, 1000)).volume(), 1, 1e-12);
  return report;
}
inline constexpr StudyInfo volumeStudy{"bar-volume", "the volume of a bar", verifyVolume};

}  // namespace ringwatch::test
