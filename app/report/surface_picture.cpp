#include <ringwatch/app/report/surface_picture.h>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/app/report/page_data.h>
#include <ringwatch/base/infinity.h>

namespace ringwatch {
namespace {

void appendNumber(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
}

void appendChunk(std::string& file, std::string_view kind, std::string_view content) {
  appendNumber(file, static_cast<std::uint32_t>(content.size()));
  std::string checked(kind);
  checked += content;
  file += checked;
  appendNumber(file, static_cast<std::uint32_t>(
                         crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()))));
}

/// PNG (ISO/IEC 15948) of 8-bit RGBA.
std::string pngFile(const std::vector<std::uint8_t>& pixels, int width, int height) {
  std::string file("\x89PNG\r\n\x1a\n", 8);
  std::string head;
  appendNumber(head, static_cast<std::uint32_t>(width));
  appendNumber(head, static_cast<std::uint32_t>(height));
  head += std::string("\x08\x06\x00\x00\x00", 5);  // 8 bits, RGBA, the only packing, filter and order
  appendChunk(file, "IHDR", head);
  std::string rows;
  for (int y = 0; y < height; ++y) {
    rows += '\0';  // no filter
    rows.append(reinterpret_cast<const char*>(pixels.data()) + std::size_t{4} * y * width, std::size_t{4} * width);
  }
  appendChunk(file, "IDAT", deflated(rows));
  appendChunk(file, "IEND", "");
  return file;
}

}  // namespace

std::array<std::uint8_t, 3> scaleColour(double share) {
  if (std::isnan(share)) return {150, 150, 150};
  // Five colours of ColorBrewer's RdYlBu.
  constexpr std::array<std::array<double, 3>, 5> stops{
      {{165, 0, 38}, {244, 109, 67}, {254, 224, 144}, {116, 173, 209}, {49, 54, 149}}};
  const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const auto low = std::min<std::size_t>(static_cast<std::size_t>(at), stops.size() - 2);
  const double part = at - static_cast<double>(low);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint8_t>(std::lround(stops[low][i] + part * (stops[low + 1][i] - stops[low][i])));
  return colour;
}

std::array<Eigen::Vector3d, 3> pictureAxes(const Eigen::Vector3d& box) {
  // From the front, 25 degrees to the side and 22 above; a body that is longest in y is looked at along x, and one that
  // is tallest stands.
  const double turn = 25 * EIGEN_PI / 180, above = 22 * EIGEN_PI / 180;
  Eigen::Vector3d towards(std::sin(turn) * std::cos(above), -std::cos(turn) * std::cos(above), std::sin(above));
  if (box.y() > box.x()) towards = Eigen::Vector3d(-towards.y(), towards.x(), towards.z());
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(towards).normalized();
  return {right, towards.cross(right), towards};
}

std::string surfacePng(const Eigen::Matrix3Xf& positions, std::span<const ColouredTriangle> triangles, int width,
                       int height) {
  Eigen::Vector3d least = Eigen::Vector3d::Constant(infinity), largest = -least;
  const auto isDrawn = [&](const ColouredTriangle& t) {
    return std::all_of(t.nodes.begin(), t.nodes.end(), [&](std::int32_t n) { return positions.col(n).allFinite(); });
  };
  for (const ColouredTriangle& t : triangles)
    if (isDrawn(t))
      for (const std::int32_t n : t.nodes) {
        least = least.cwiseMin(positions.col(n).cast<double>());
        largest = largest.cwiseMax(positions.col(n).cast<double>());
      }
  if (!(least.x() <= largest.x())) return {};
  const auto [right, up, towards] = pictureAxes(largest - least);
  Eigen::Matrix3d axes;
  axes << right.transpose(), up.transpose(), towards.transpose();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(infinity), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d seen =
        axes * Eigen::Vector3d((corner & 1) ? largest.x() : least.x(), (corner & 2) ? largest.y() : least.y(),
                               (corner & 4) ? largest.z() : least.z());
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  const double border = 4;  // pixels
  const double scale = std::min((width - 2 * border) / std::max(high.x() - low.x(), 1e-300),
                                (height - 2 * border) / std::max(high.y() - low.y(), 1e-300));
  const Eigen::Vector3d middle = 0.5 * (low + high);
  std::vector<std::uint8_t> pixels(std::size_t{4} * width * height, 0);
  std::vector<float> depth(static_cast<std::size_t>(width) * height, -std::numeric_limits<float>::infinity());
  const Eigen::Vector3d light = (0.4 * right + 0.6 * up + towards).normalized();
  for (const ColouredTriangle& t : triangles) {
    if (!isDrawn(t)) continue;
    std::array<Eigen::Vector3d, 3> p;  // x, y in pixels, z towards the reader
    std::array<Eigen::Vector3d, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = positions.col(t.nodes[k]).cast<double>();
      const Eigen::Vector3d seen = (axes * corner[k] - middle) * scale;
      p[k] = {0.5 * width + seen.x(), 0.5 * height - seen.y(), seen.z()};
    }
    const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    const double shade = 0.55 + 0.45 * std::abs(normal.dot(light));
    const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (p[1].y() - p[0].y());
    if (area == 0 || !std::isfinite(area)) continue;
    const auto [left, rightmost] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [top, bottom] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for (int y = std::max(0, static_cast<int>(top)); y <= std::min(height - 1, static_cast<int>(bottom)); ++y)
      for (int x = std::max(0, static_cast<int>(left)); x <= std::min(width - 1, static_cast<int>(rightmost)); ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const auto share = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
          return ((a.x() - px) * (b.y() - py) - (b.x() - px) * (a.y() - py)) / area;
        };
        const double u = share(p[1], p[2]), v = share(p[2], p[0]), w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        const auto z = static_cast<float>(u * p[0].z() + v * p[1].z() + w * p[2].z());
        const std::size_t at = static_cast<std::size_t>(y) * width + x;
        if (z <= depth[at]) continue;
        depth[at] = z;
        for (std::size_t i = 0; i < 3; ++i) pixels[4 * at + i] = static_cast<std::uint8_t>(shade * t.colour[i]);
        pixels[4 * at + 3] = 255;
      }
  }
  return pngFile(pixels, width, height);
}

}  // namespace ringwatch
