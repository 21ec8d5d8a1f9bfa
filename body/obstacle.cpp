#include <ringwatch/body/obstacle.h>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

Eigen::Vector3d unit(const char* name, const Eigen::Vector3d& direction) {
  const double length = direction.norm();
  if (!(length > 0) || !std::isfinite(length))
    throw InputError(
        joinText(name, " = [", direction[0], ", ", direction[1], ", ", direction[2], "]: must be finite and not zero"));
  return direction / length;
}
void requirePositive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) throw InputError(joinText(name, " = ", value, " m: must be > 0"));
}

/// Distances of nodes without a call for each. Shape: has at(), and origin(), which it takes points from.
template <class Shape>
class ObstacleOf : public Obstacle {
 public:
  std::size_t within(double gap, NodeVectorsView x, std::span<const std::int32_t> nodes,
                     const Eigen::Vector3d& displacement, std::int32_t* near) const final {
    // The same expression may be rounded otherwise here than in at(): a few roundings of the point's coordinates.
    constexpr double rounding = 32 * std::numeric_limits<double>::epsilon();
    const auto& shape = static_cast<const Shape&>(*this);
    std::size_t count = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Eigen::Vector3d point = x.col(nodes[k]) - displacement;
      const double room = rounding * (point - shape.origin()).template lpNorm<1>();
      near[count] = static_cast<std::int32_t>(k);
      count += !(shape.Shape::at(point).gap > gap + room);  // of what is not a number at() decides
    }
    return count;
  }
};

class Plane final : public ObstacleOf<Plane> {
 public:
  Plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) : point_(point), normal_(unit("normal", normal)) {}
  Surface at(const Eigen::Vector3d& x) const override {
    return {normal_.dot(x - point_), normal_, Eigen::Matrix3d::Zero()};
  }
  const Eigen::Vector3d& origin() const { return point_; }

 private:
  Eigen::Vector3d point_, normal_;
};

/// Round obstacles: the distance of a vector r from a centre or an axis, |r| - R or R - |r|. across: the directions in
/// which r lives.
Obstacle::Surface roundSurface(const Eigen::Vector3d& r, const Eigen::Matrix3d& across, double radius, bool hollow) {
  const double distance = r.norm(), sign = hollow ? -1 : 1;
  if (!(distance > 0)) return {sign * -radius, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  const Eigen::Vector3d n = r / distance;
  return {sign * (distance - radius), sign * n, (sign / distance) * (across - n * n.transpose())};
}

class Sphere final : public ObstacleOf<Sphere> {
 public:
  Sphere(Eigen::Vector3d centre, double radius, bool hollow)
      : centre_(std::move(centre)), radius_(radius), hollow_(hollow) {
    requirePositive("radius", radius);
  }
  Surface at(const Eigen::Vector3d& x) const override {
    return roundSurface(x - centre_, Eigen::Matrix3d::Identity(), radius_, hollow_);
  }
  const Eigen::Vector3d& origin() const { return centre_; }

 private:
  Eigen::Vector3d centre_;
  double radius_;
  bool hollow_;
};

class Cylinder final : public ObstacleOf<Cylinder> {
 public:
  Cylinder(Eigen::Vector3d point, const Eigen::Vector3d& axis, double radius, std::optional<double> length, bool hollow)
      : point_(std::move(point)),
        axis_(unit("axis", axis)),
        across_(Eigen::Matrix3d::Identity() - axis_ * axis_.transpose()),
        radius_(radius),
        length_(length),
        hollow_(hollow) {
    requirePositive("radius", radius);
    if (length) requirePositive("length", *length);
    if (length && hollow) throw InputError("length: a hollow cylinder has no ends; take one of the two out");
  }
  Surface at(const Eigen::Vector3d& x) const override {
    const Eigen::Vector3d r = x - point_;
    const double along = axis_.dot(r);
    Surface side = roundSurface(r - along * axis_, across_, radius_, hollow_);
    if (!length_) return side;
    const double beyond = std::abs(along) - 0.5 * *length_;
    if (beyond <= side.gap) return side;
    return {beyond, along < 0 ? Eigen::Vector3d(-axis_) : axis_, Eigen::Matrix3d::Zero()};
  }
  const Eigen::Vector3d& origin() const { return point_; }

 private:
  Eigen::Vector3d point_, axis_;
  Eigen::Matrix3d across_;
  double radius_;
  std::optional<double> length_;
  bool hollow_;
};

class Box final : public ObstacleOf<Box> {
 public:
  Box(Eigen::Vector3d centre, const Eigen::Vector3d& size) : centre_(std::move(centre)), half_(0.5 * size) {
    for (int c = 0; c < 3; ++c) requirePositive("size", size[c]);
  }
  Surface at(const Eigen::Vector3d& x) const override {
    const Eigen::Vector3d r = x - centre_, beyond = r.cwiseAbs() - half_;
    int face = 0;
    const double gap = beyond.maxCoeff(&face);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    normal[face] = r[face] < 0 ? -1 : 1;
    return {gap, normal, Eigen::Matrix3d::Zero()};
  }
  const Eigen::Vector3d& origin() const { return centre_; }

 private:
  Eigen::Vector3d centre_, half_;
};

}  // namespace

std::unique_ptr<Obstacle> planeObstacle(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  return std::make_unique<Plane>(point, normal);
}
std::unique_ptr<Obstacle> sphereObstacle(const Eigen::Vector3d& centre, double radius, bool hollow) {
  return std::make_unique<Sphere>(centre, radius, hollow);
}
std::unique_ptr<Obstacle> cylinderObstacle(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius,
                                           std::optional<double> length, bool hollow) {
  return std::make_unique<Cylinder>(point, axis, radius, length, hollow);
}
std::unique_ptr<Obstacle> boxObstacle(const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
  return std::make_unique<Box>(centre, size);
}

const std::vector<ObstacleKind>& allObstacleKinds() {
  using P = ObstacleParameters;
  static const std::vector<ObstacleKind> kinds{
      {"plane",
       "all that lies below a plane",
       {"normal"},
       {},
       [](const P& p) { return planeObstacle(p.point, p.normal); }},
      {"sphere",
       "a ball; hollow: all that lies outside of it",
       {"radius"},
       {"hollow"},
       [](const P& p) { return sphereObstacle(p.point, p.radius, p.hollow); }},
      {"cylinder",
       "a cylinder, endless without a length; hollow: all that lies outside of it",
       {"axis", "radius"},
       {"length", "hollow"},
       [](const P& p) { return cylinderObstacle(p.point, p.axis, p.radius, p.length, p.hollow); }},
      {"box", "a box along the axes", {"size"}, {}, [](const P& p) { return boxObstacle(p.point, p.size); }},
  };
  return kinds;
}

}  // namespace ringwatch
