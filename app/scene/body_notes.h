#pragma once
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// How large a body is and how fast waves cross it, at rest: numbers that a wrong unit makes absurd.
struct BodyFigures {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // m, along x, y, z
  double slowest = 0, fastest = 0;                 // m/s, pressure waves of its materials
  /// Time, s, in which the fastest wave runs along the longest side.
  double crossing() const { return size.maxCoeff() / fastest; }
  std::string text() const;
  nlohmann::ordered_json json() const;
};
BodyFigures bodyFigures(const Body& body);

/// What a user may not have meant, one sentence each: elements with modes that nothing resists, a body that nothing
/// holds, and a wave speed that no solid has, with the units that would explain it.
std::vector<std::string> bodyNotes(const Body& body, bool held);
/// The same of a body as a whole, and whether it is so large that its mesh may be in mm.
std::vector<std::string> bodyNotes(const Body& body);
/// What of a body of the scene is not in its bracket, one line each.
std::vector<std::string> notesOfBracket(const Scene& scene, const Body& body);
/// Whether supports, springs or contact may keep a body from flying off.
bool isHeld(const Body& body);

}  // namespace ringwatch
