#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>

#include <Eigen/Core>

namespace ringwatch {

/// Colour of a step on a scale: 0 is the least one, red, over yellow to 1, blue; a colour-blind reader can tell them
/// apart. NaN: grey.
std::array<std::uint8_t, 3> scaleColour(double share);

/// A triangle's corners (columns of the positions) and its colour.
struct ColouredTriangle {
  std::array<std::int32_t, 3> nodes;
  std::array<std::uint8_t, 3> colour;
};

/// The directions of a picture of a body: to the right, up and towards the reader, orthonormal, the longest extent of
/// the body to the right. box: extents in x, y and z, m.
std::array<Eigen::Vector3d, 3> pictureAxes(const Eigen::Vector3d& box);

/// A surface as a PNG file with a transparent ground, seen from above and in front; positions: 3×N, m. "" where nothing
/// finite is to be seen.
std::string surfacePng(const Eigen::Matrix3Xf& positions, std::span<const ColouredTriangle> triangles, int width,
                       int height);

}  // namespace ringwatch
