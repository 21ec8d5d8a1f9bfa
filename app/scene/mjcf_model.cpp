#include <ringwatch/app/scene/mjcf_model.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <pugixml.hpp>

#include <ringwatch/app/scene/toml_text.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/mesh_io.h>

namespace ringwatch {
namespace {

namespace fs = std::filesystem;

/// Bodies within bodies, at most, and vertices of a grid.
constexpr int mostNested = 200;
constexpr std::size_t mostVertices = 100'000'000;

/// A file of the model.
struct XmlSource {
  fs::path path;
  std::string text;
  pugi::xml_document document;
};
/// An element with the file that it is in.
struct XmlElement {
  pugi::xml_node node;
  const XmlSource* source = nullptr;

  std::string name() const { return node.name(); }
  /// "model.xml:12"
  std::string place() const {
    const auto at =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)), source->text.size());
    return fmt::format(
        "{}:{}", source->path.string(),
        1 + std::count(source->text.begin(), source->text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }
  std::string origin() const { return fmt::format("{}: <{}>", place(), node.name()); }
  bool has(const char* attribute) const { return !node.attribute(attribute).empty(); }
  std::string text(const char* attribute, const char* usual = "") const {
    return node.attribute(attribute).as_string(usual);
  }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(fmt::format("{} {}", origin(), what)); }
  [[noreturn]] void fail(const char* attribute, const std::string& what) const {
    fail(fmt::format("{}={}: {}", attribute, inQuotes(text(attribute)), what));
  }

  /// The numbers of an attribute; count: how many, 0 for any.
  std::vector<double> reals(const char* attribute, std::size_t count) const {
    return numbers<double>(attribute, count, count == 1 ? "a number" : "numbers");
  }
  std::vector<std::int64_t> integers(const char* attribute, std::size_t count = 0) const {
    return numbers<std::int64_t>(attribute, count, "whole numbers");
  }
  double real(const char* attribute, double usual) const { return has(attribute) ? reals(attribute, 1)[0] : usual; }
  Eigen::Vector3d vector(const char* attribute, const Eigen::Vector3d& usual) const {
    return has(attribute) ? Eigen::Vector3d(Eigen::Vector3d::Map(reals(attribute, 3).data())) : usual;
  }
  /// One of some words.
  std::string word(const char* attribute, std::span<const std::string_view> known) const {
    const std::string own = has(attribute) ? text(attribute) : std::string(known.front());
    if (std::ranges::find(known, own) == known.end())
      fail(attribute, fmt::format("{}known are {}", didYouMean(own, known), fmt::join(known, ", ")));
    return own;
  }
  bool flag(const char* attribute) const {
    static constexpr std::string_view words[] = {"false", "true"};
    return word(attribute, words) == "true";
  }
  /// Throws for an attribute that is none of these.
  void allow(std::initializer_list<std::string_view> known) const {
    for (const pugi::xml_attribute& own : node.attributes())
      if (std::ranges::find(known, std::string_view(own.name())) == known.end())
        fail(fmt::format("has no attribute {}; {}it takes {}", inQuotes(own.name()),
                         didYouMean(own.name(), std::vector<std::string_view>(known)), fmt::join(known, ", ")));
  }

 private:
  template <class Number>
  std::vector<Number> numbers(const char* attribute, std::size_t count, const char* what) const {
    std::vector<Number> values;
    const std::string all = text(attribute);
    const char *at = all.data(), *const end = at + all.size();
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    for (at = std::find_if_not(at, end, blank); at != end; at = std::find_if_not(at, end, blank)) {
      Number& value = values.emplace_back();
      const auto [stop, error] = std::from_chars(at, end, value);
      if (error != std::errc() || (stop != end && !blank(*stop)) || !std::isfinite(static_cast<double>(value))) {
        fail(attribute, fmt::format("must be {}", what));
      }
      at = stop;
    }
    if (count != 0 && values.size() != count)
      fail(attribute, count == 1 ? std::string("must be a number") : fmt::format("must be {} {}", count, what));
    return values;
  }
};

/// Files and the elements in them: <include> stands for the elements of its file.
class XmlFiles {
 public:
  explicit XmlFiles(const fs::path& main) : main_(main) {}

  XmlElement root() { return read(main_, main_.string()); }

  std::vector<XmlElement> children(const XmlElement& parent) {
    std::vector<XmlElement> all;
    addChildren(parent, all);
    return all;
  }
  std::vector<XmlElement> children(const XmlElement& parent, std::string_view name) {
    std::vector<XmlElement> all = children(parent);
    std::erase_if(all, [&](const XmlElement& one) { return one.name() != name; });
    return all;
  }

 private:
  XmlElement read(const fs::path& path, const std::string& what) {
    auto source = std::make_unique<XmlSource>();
    source->path = path;
    source->text = detail::readWholeFile(path);
    const pugi::xml_parse_result parsed = source->document.load_buffer(source->text.data(), source->text.size());
    const auto fault = [&](std::ptrdiff_t at, std::string_view text) {
      const auto begin = source->text.begin(), end = begin + std::min(at, std::ssize(source->text));
      return InputError(fmt::format("{}:{}: {}", path.string(), 1 + std::count(begin, end, '\n'), text));
    };
    if (!parsed) throw fault(parsed.offset, fmt::format("not XML: {}", parsed.description()));
    // Names go into files of JSON.
    if (const std::size_t at = firstNotUtf8(source->text);
        parsed.encoding == pugi::encoding_utf8 && at < source->text.size())
      throw fault(static_cast<std::ptrdiff_t>(at), "not UTF-8; save the model as UTF-8");
    const XmlElement root{source->document.document_element(), source.get()};
    if (root.node.empty()) throw InputError(fmt::format("{}: has no element", what));
    sources_.push_back(std::move(source));
    return root;
  }
  /// As in MuJoCo a file is looked for beside the main one, and here also beside the one that includes it.
  void addChildren(const XmlElement& parent, std::vector<XmlElement>& all) {
    for (const pugi::xml_node& node : parent.node.children()) {
      if (node.type() != pugi::node_element) continue;
      const XmlElement element{node, parent.source};
      if (element.name() != "include") {
        all.push_back(element);
        continue;
      }
      if (!element.has("file")) element.fail("has no file");
      std::error_code error;
      fs::path path = main_.parent_path() / element.text("file");
      if (!fs::exists(path, error)) path = parent.source->path.parent_path() / element.text("file");
      if (!fs::exists(path, error)) element.fail("file", "there is no such file");
      auto& root = included_[node.internal_object()];
      if (root.node.empty()) {
        for (const auto& known : sources_)
          if (fs::equivalent(known->path, path, error)) element.fail("file", "is included already");
        root = read(path, element.origin());
      }
      addChildren(root, all);
    }
  }

  fs::path main_;
  std::vector<std::unique_ptr<XmlSource>> sources_;
  std::map<const void*, XmlElement> included_;  // by the <include>
};

/// A frame in the world, and the joint that moves it, where one does.
struct Pose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  XmlElement mover = {};

  bool moves() const { return mover.source != nullptr; }
  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const { return R * point + t; }
};

/// A body of the tree.
struct TreeBody {
  XmlElement element;
  Pose pose;  // its own joints move it too
  bool parentMoves;
  std::string childClass;
  bool isVertex = false;  // of a flex
};

/// Whose attributes joints have.
struct DefaultClass {
  std::string parent;
  std::vector<XmlElement> joints;
};

class MjcfReader {
 public:
  explicit MjcfReader(const fs::path& file) : file_(file), files_(file) { model_.optionOrigin = file.string(); }

  FlexModel read() {
    const XmlElement root = files_.root();
    if (root.name() != "mujoco") root.fail("is no MuJoCo model; its root element must be <mujoco>");
    for (const XmlElement& section : files_.children(root, "compiler")) readCompiler(section);
    for (const XmlElement& section : files_.children(root, "option")) readOption(section);
    for (const XmlElement& section : files_.children(root, "default")) readDefault(section, "");
    for (const XmlElement& section : files_.children(root, "worldbody")) readTree(section, Pose{}, "", 0);
    for (const XmlElement& section : files_.children(root, "deformable"))
      for (const XmlElement& child : files_.children(section)) {
        if (child.name() == "flex")
          readFlex(child);
        else
          leaveOut(child.name());
      }
    if (model_.flexes.empty())
      throw InputError(
          fmt::format("{}: no <flexcomp dim=\"3\"> or <flex dim=\"3\"> that deforms, whose step could be told{}",
                      file_.string(), left_.empty() ? "" : "; there are " + leftOut()));
    refuseImplicitElasticity();
    for (const XmlElement& section : files_.children(root)) {
      const std::string name = section.name();
      for (const char* counted : {"equality", "contact", "tendon", "actuator", "sensor", "keyframe"})
        if (name == counted)
          for (const XmlElement& child : files_.children(section)) {
            if (name == "equality") checkEquality(child);
            if (name == "actuator" || name == "tendon") checkReach(child);
            leaveOut(name == "contact" ? "contact " + child.name() : child.name());
          }
    }
    for (const TreeBody& body : bodies_)
      if (!body.isVertex) {
        leaveOut("body");
        for (const XmlElement& child : files_.children(body.element))
          if (child.name() == "joint" || child.name() == "freejoint") leaveOut(child.name());
      }
    std::set<std::string> names;
    for (const Flex& flex : model_.flexes)
      if (!names.insert(flex.name).second)
        throw InputError(fmt::format("{}: {} is the name of another flex, too", flex.origin, inQuotes(flex.name)));
    model_.notes.push_back(
        fmt::format("{}: contact is a constraint of MuJoCo's solver, and in no bracket", file_.string()));
    for (const auto& [attribute, left] : leftOutOfJoints_)
      leaveOutOnTheSafeSide(left.first, fmt::format("{} of the joints of vertices{}", attribute,
                                                    left.count == 1 ? "" : fmt::format(" ({} times)", left.count)));
    if (!left_.empty())
      model_.notes.push_back(fmt::format("{}: left out, they are no 3-D flexes: {}", file_.string(), leftOut()));
    return std::move(model_);
  }

 private:
  void leaveOut(const std::string& what) { ++left_[what]; }
  std::string leftOut() const {
    std::string text;
    for (const auto& [what, count] : left_) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    return text;
  }
  void note(const XmlElement& element, const std::string& what) {
    model_.notes.push_back(fmt::format("{} {}", element.origin(), what));
  }
  /// Of what makes every step stable that is stable without.
  void leaveOutOnTheSafeSide(const std::string& origin, const std::string& what) {
    model_.notes.push_back(fmt::format("{} {}: left out, it can only let larger steps be stable", origin, what));
    model_.leavesOutWhatEnlargesTheStep = true;
  }

  void readCompiler(const XmlElement& e) {
    static constexpr std::string_view angles[] = {"degree", "radian"};
    if (e.has("angle")) degrees_ = e.word("angle", angles) == "degree";
    if (e.has("eulerseq")) {
      eulerOrder_ = e.text("eulerseq");
      if (eulerOrder_.size() != 3 || eulerOrder_.find_first_not_of("xyzXYZ") != std::string::npos)
        e.fail("eulerseq", "must be three of x, y, z, X, Y, Z");
    }
    if (e.has("assetdir")) meshFolder_ = e.text("assetdir");
    if (e.has("meshdir")) meshFolder_ = e.text("meshdir");
    if (e.has("strippath")) stripsPath_ = e.flag("strippath");
    if (e.real("settotalmass", -1) > 0) e.fail("settotalmass", "masses of flexes would be scaled; leave it out");
    if (e.real("boundmass", 0) > 0) leastMass_ = e.real("boundmass", 0);
    if (e.text("inertiafromgeom") == "true") inertiaFromGeoms_ = true;
  }

  void readOption(const XmlElement& e) {
    static constexpr std::string_view integrators[] = {"Euler", "RK4", "implicit", "implicitfast"};
    if (e.has("timestep")) {
      model_.timestep = e.real("timestep", 0);
      if (!(model_.timestep > 0)) e.fail("timestep", "must be > 0, s");
    }
    if (e.has("integrator")) model_.integrator = e.word("integrator", integrators);
    if (e.has("timestep") || e.has("integrator")) model_.optionOrigin = e.origin();
    model_.gravity = e.vector("gravity", model_.gravity);
    if (e.has("solver")) solver_ = e.text("solver");
    if (e.has("cone")) cone_ = e.text("cone");
    for (const char* medium : {"density", "viscosity"})
      if (e.real(medium, 0) != 0) e.fail(medium, "a medium damps the vertices, which the bracket does not know");
    for (const XmlElement& flags : files_.children(e, "flag")) {
      for (const char* force : {"passive", "spring", "damper"})
        if (flags.text(force) == "disable") flags.fail(force, "takes forces of flexes away; leave it out");
      if (flags.text("gravity") == "disable") model_.gravity.setZero();
      if (flags.text("sleep") == "enable") sleeps_ = true;
      if (flags.text("eulerdamp") == "disable") dampsJointsExplicitly_ = true;
    }
  }
  /// From MuJoCo 3.11 on.
  void refuseImplicitElasticity() const {
    if (model_.implicitDamping() && solver_ == "CG" && cone_ != "elliptic" && !sleeps_)
      throw InputError(
          fmt::format("{} integrator=\"{}\" with solver=\"CG\" integrates the elasticity of flexes implicitly: there "
                      "is no largest step",
                      model_.optionOrigin, model_.integrator));
  }

  void readDefault(const XmlElement& e, const std::string& parent) {
    const std::string name = parent.empty() ? e.text("class", "main") : e.text("class");
    if (name.empty()) e.fail("has no class");
    DefaultClass& own = defaults_[name];
    own.parent = parent;
    for (const XmlElement& child : files_.children(e)) {
      if (child.name() == "joint") defaults_[name].joints.push_back(child);
      if (child.name() == "default") readDefault(child, name);
    }
  }
  /// The element that gives an attribute of a joint: itself, or its classes.
  std::optional<XmlElement> giver(const std::optional<XmlElement>& joint, std::string classes,
                                  const char* attribute) const {
    if (joint && joint->has(attribute)) return joint;
    if (joint && joint->has("class")) classes = joint->text("class");
    if (classes.empty()) classes = "main";
    for (int i = 0; i < mostNested && !classes.empty(); ++i) {
      const auto found = defaults_.find(classes);
      if (found == defaults_.end()) break;
      for (const XmlElement& one : found->second.joints)
        if (one.has(attribute)) return one;
      classes = found->second.parent;
    }
    return std::nullopt;
  }
  /// What the joints of a vertex do to it beside letting it move.
  void checkJoint(const std::optional<XmlElement>& joint, const std::string& classes) {
    for (const char* force : {"stiffness", "springdamper", "frictionloss"})
      if (const auto e = giver(joint, classes, force)) {
        const std::vector<double> values = e->reals(force, 0);
        if (std::ranges::any_of(values, [](double value) { return value != 0; }))
          e->fail(force, "of the joints of vertices is not here; take it out");
      }
    for (const char* force : {"damping", "armature"})
      if (const auto e = giver(joint, classes, force)) {
        const std::vector<double> values = e->reals(force, 0);
        if (std::ranges::all_of(values, [](double value) { return value == 0; })) continue;
        const bool isExplicit = model_.integrator == "RK4" || (model_.integrator == "Euler" && dampsJointsExplicitly_);
        if (force == std::string_view("damping") && isExplicit)
          e->fail(force, "of the joints of vertices is explicit with this integrator, and not here; take it out");
        if (!safelyLeftOut_.insert({e->node.internal_object(), force}).second) continue;
        LeftOutOfJoints& left = leftOutOfJoints_[force];
        if (left.count++ == 0) left.first = e->origin();
      }
  }

  Eigen::Matrix3d rotation(const XmlElement& e) const {
    const char* given = nullptr;
    for (const char* one : {"quat", "axisangle", "xyaxes", "zaxis", "euler"})
      if (e.has(one)) {
        if (given) e.fail(one, fmt::format("{} is given too; give one of them", given));
        given = one;
      }
    if (!given) return Eigen::Matrix3d::Identity();
    const std::string_view kind = given;
    const double unit = degrees_ ? std::numbers::pi / 180 : 1;
    const auto direction = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
      if (!(v.norm() > 0)) e.fail(given, "is no direction");
      return v.normalized();
    };
    if (kind == "quat") {
      const std::vector<double> q = e.reals(given, 4);
      const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
      if (!(quaternion.norm() > 0)) e.fail(given, "is no rotation");
      return quaternion.normalized().toRotationMatrix();
    }
    if (kind == "axisangle") {
      const std::vector<double> a = e.reals(given, 4);
      return Eigen::AngleAxisd(unit * a[3], direction({a[0], a[1], a[2]})).toRotationMatrix();
    }
    if (kind == "xyaxes") {
      const std::vector<double> a = e.reals(given, 6);
      const Eigen::Vector3d x = direction({a[0], a[1], a[2]}), y(a[3], a[4], a[5]);
      Eigen::Matrix3d R;
      R.col(0) = x;
      R.col(1) = direction(y - x.dot(y) * x);
      R.col(2) = R.col(0).cross(R.col(1));
      return R;
    }
    if (kind == "zaxis") {
      const Eigen::Vector3d z = direction(e.vector(given, {})), axis = Eigen::Vector3d::UnitZ().cross(z);
      return Eigen::AngleAxisd(std::atan2(axis.norm(), z.z()),
                               axis.isZero(0) ? Eigen::Vector3d::UnitX() : Eigen::Vector3d(axis.normalized()))
          .toRotationMatrix();
    }
    const std::vector<double> angles = e.reals(given, 3);
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto letter = static_cast<unsigned char>(eulerOrder_[i]);
      const bool turnsWith = std::islower(letter) != 0;
      const Eigen::Matrix3d one =
          Eigen::AngleAxisd(unit * angles[i], Eigen::Vector3d::Unit(std::tolower(letter) - 'x')).toRotationMatrix();
      R = turnsWith ? Eigen::Matrix3d(R * one) : Eigen::Matrix3d(one * R);
    }
    return R;
  }
  Pose within(const Pose& parent, const XmlElement& e) const {
    return {parent.R * rotation(e), parent(e.vector("pos", Eigen::Vector3d::Zero())), parent.mover};
  }

  void readTree(const XmlElement& e, const Pose& pose, const std::string& childClass, int depth) {
    if (depth > mostNested) e.fail(fmt::format("is one of more than {} bodies within each other", mostNested));
    for (const XmlElement& child : files_.children(e)) {
      const std::string name = child.name();
      const std::string classes = child.has("childclass") ? child.text("childclass") : childClass;
      if (name == "body") {
        TreeBody body{child, within(pose, child), pose.moves(), classes};
        for (const XmlElement& one : files_.children(child))
          if (one.name() == "joint" || one.name() == "freejoint") body.pose.mover = one;
        if (child.has("mocap") && child.flag("mocap")) body.pose.mover = child;
        bodies_.push_back(body);
        readTree(child, body.pose, classes, depth + 1);
      } else if (name == "frame") {
        readTree(child, within(pose, child), classes, depth + 1);
      } else if (name == "flexcomp") {
        readFlexcomp(child, pose);
      } else if (name != "joint" && name != "freejoint" && name != "inertial") {
        if (!child.node.find_node([](const pugi::xml_node& n) { return std::string_view(n.name()) == "flexcomp"; })
                 .empty())
          child.fail("has a flexcomp in it; write it out");
        leaveOut(name);
      }
    }
  }

  static constexpr double smallest = 1e-15;  // MuJoCo's mjMINVAL

  void readFlexcomp(const XmlElement& e, const Pose& parent) {
    static constexpr std::string_view types[] = {"grid",   "box",    "cylinder", "ellipsoid", "disc",
                                                 "circle", "square", "mesh",     "gmsh",      "direct"};
    static constexpr std::string_view dofs[] = {"full", "radial", "trilinear", "quadratic", "2d"};
    e.allow({"name",  "type",     "group",      "dim",   "dof",       "count",  "cellcount", "spacing",  "radius",
             "rigid", "mass",     "inertiabox", "scale", "file",      "point",  "element",   "texcoord", "material",
             "rgba",  "flatskin", "pos",        "quat",  "axisangle", "xyaxes", "zaxis",     "euler",    "origin"});
    const std::string type = e.word("type", types);
    std::int64_t dim = e.has("dim") ? e.integers("dim", 1)[0] : 2;
    if (dim < 1 || dim > 3) e.fail("dim", "must be 1, 2 or 3");
    if (type == "disc" || type == "square") dim = 2;
    if (type == "gmsh" && !e.has("dim")) dim = 3;  // as its file says, which must have tetrahedra
    if (dim != 3) return leaveOut(fmt::format("flexcomp of dim {}", dim));
    if (e.has("rigid") && e.flag("rigid")) return leaveOut("rigid flexcomp");
    if (const std::string dof = e.word("dof", dofs); dof != "full")
      e.fail("dof", "its vertices do not move freely; the step of dof=\"full\" alone can be told");
    if (!e.has("name")) e.fail("has no name");
    if (parent.moves())
      e.fail(fmt::format("is in a body that moves ({}), whose inertia its vertices share; its step cannot be told",
                         parent.mover.origin()));

    Flex flex;
    flex.name = e.text("name");
    flex.origin = e.origin();
    std::array<std::int64_t, 3> count{10, 10, 10};
    if (e.has("count")) std::ranges::copy(e.integers("count", 3), count.begin());
    if (type == "direct") {
      readDirect(e, flex);
    } else if (type == "gmsh") {
      readGmsh(e, flex);
    } else if (type == "grid") {
      makeGrid(e, count, flex);
    } else if (type == "box" || type == "cylinder" || type == "ellipsoid") {
      makeShell(e, type, count, flex);
    } else {
      e.fail("type", "of dim 3 is not read; give its tetrahedra by type=\"gmsh\" or \"direct\"");
    }
    const Pose own{rotation(e), e.vector("pos", Eigen::Vector3d::Zero())};
    for (Eigen::Vector3d& point : flex.points) point = parent(own(point));

    std::vector<bool> pinned(flex.points.size(), false);
    for (const XmlElement& child : files_.children(e)) {
      if (child.name() == "pin")
        readPin(child, type == "grid", count, pinned);
      else
        readForces(child, flex);
    }
    keepUsed(flex, pinned);
    const double mass = e.real("mass", 1);
    if (!(mass > smallest)) e.fail("mass", "must be > 0, kg");
    flex.masses.assign(flex.points.size(), std::max(mass / static_cast<double>(flex.points.size()), leastMass_));
    checkJoint(std::nullopt, "");
    add(e, std::move(flex));
  }

  void readDirect(const XmlElement& e, Flex& flex) const {
    if (!e.has("point") || !e.has("element")) e.fail("of type direct needs point and element");
    takePoints(e, "point", flex);
    const Eigen::Vector3d scale = e.vector("scale", {1, 1, 1});
    for (Eigen::Vector3d& point : flex.points) point = point.cwiseProduct(scale);
    takeTetrahedra(e, flex);
  }
  static void takePoints(const XmlElement& e, const char* attribute, Flex& flex) {
    const std::vector<double> numbers = e.reals(attribute, 0);
    if (numbers.size() % 3 != 0) e.fail(attribute, "must be points of three numbers each");
    for (std::size_t i = 0; i < numbers.size(); i += 3) flex.points.emplace_back(Eigen::Vector3d::Map(&numbers[i]));
  }
  static void takeTetrahedra(const XmlElement& e, Flex& flex) {
    const std::vector<std::int64_t> numbers = e.integers("element");
    if (numbers.empty() || numbers.size() % 4 != 0) e.fail("element", "must be tetrahedra of four vertices each");
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
      auto& own = flex.tetrahedra.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) own[k] = vertex(e, "element", numbers[i + k], flex.points.size());
    }
  }
  static std::int32_t vertex(const XmlElement& e, const char* attribute, std::int64_t number, std::size_t count) {
    if (number < 0 || number >= static_cast<std::int64_t>(count))
      e.fail(fmt::format("{}: there is no vertex {}; there are {}, counted from 0", attribute, number, count));
    return static_cast<std::int32_t>(number);
  }

  void readGmsh(const XmlElement& e, Flex& flex) const {
    if (!e.has("file")) e.fail("of type gmsh needs a file");
    fs::path name = e.text("file");
    if (stripsPath_) name = name.filename();
    const fs::path path = file_.parent_path() / meshFolder_ / name;
    std::error_code error;
    if (!fs::exists(path, error)) e.fail("file", fmt::format("there is no {}", path.string()));
    const Mesh mesh = readMesh(path);
    const Eigen::Vector3d scale = e.vector("scale", {1, 1, 1});
    for (Eigen::Index i = 0; i < mesh.X.cols(); ++i) flex.points.emplace_back(mesh.X.col(i).cwiseProduct(scale));
    for (const MeshBlock& block : mesh.blocks) {
      if (block.type != elementTypeOf<Tet4>)
        e.fail("file", fmt::format("has elements {}; a flex has linear tetrahedra", elementInfo(block.type).name));
      for (std::size_t i = 0; i < block.elementCount(); ++i)
        std::copy_n(block.element(i), 4, flex.tetrahedra.emplace_back().begin());
    }
    if (flex.tetrahedra.empty()) e.fail("file", "has no tetrahedra");
  }

  static void checkCount(const XmlElement& e, const std::array<std::int64_t, 3>& count) {
    double vertices = 1;
    for (const std::int64_t one : count) {
      if (one < 2) e.fail(fmt::format("count: {}: must be 2 or more in each direction of dim 3", one));
      vertices *= static_cast<double>(one);
    }
    if (vertices > static_cast<double>(mostVertices))
      e.fail(fmt::format("count: {:.3g} vertices; at most {} are possible", vertices, mostVertices));
  }
  static Eigen::Vector3d spacingOf(const XmlElement& e) {
    const Eigen::Vector3d spacing = e.vector("spacing", Eigen::Vector3d::Constant(0.02));
    if (!(spacing.minCoeff() > 0)) e.fail("spacing", "must be > 0, m");
    return spacing;
  }

  /// z runs fastest. A cell has six tetrahedra around its diagonal from corner 1 to corner 7, both in VTK's order.
  static void makeGrid(const XmlElement& e, const std::array<std::int64_t, 3>& count, Flex& flex) {
    static constexpr std::array<std::array<int, 4>, 6> tetrahedra{
        {{0, 3, 1, 7}, {0, 1, 4, 7}, {1, 3, 2, 7}, {1, 2, 6, 7}, {1, 5, 4, 7}, {1, 6, 5, 7}}};
    static constexpr std::array<std::array<int, 3>, 8> corners{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    checkCount(e, count);
    const Eigen::Vector3d spacing = spacingOf(e);
    for (std::int64_t x = 0; x < count[0]; ++x)
      for (std::int64_t y = 0; y < count[1]; ++y)
        for (std::int64_t z = 0; z < count[2]; ++z) {
          const std::array<std::int64_t, 3> at{x, y, z};
          Eigen::Vector3d& point = flex.points.emplace_back();
          for (std::size_t k = 0; k < 3; ++k)
            point[static_cast<Eigen::Index>(k)] =
                spacing[static_cast<Eigen::Index>(k)] *
                (static_cast<double>(at[k]) - 0.5 * static_cast<double>(count[k] - 1));
          if (x + 1 == count[0] || y + 1 == count[1] || z + 1 == count[2]) continue;
          for (const auto& tetrahedron : tetrahedra) {
            auto& own = flex.tetrahedra.emplace_back();
            for (std::size_t k = 0; k < 4; ++k) {
              const auto& corner = corners[static_cast<std::size_t>(tetrahedron[k])];
              own[k] = gridVertex(count, {x + corner[0], y + corner[1], z + corner[2]});
            }
          }
        }
  }
  static std::int32_t gridVertex(const std::array<std::int64_t, 3>& count, const std::array<std::int64_t, 3>& at) {
    return static_cast<std::int32_t>((at[0] * count[1] + at[1]) * count[2] + at[2]);
  }

  /// Vertices on the surface of a grid and one in its middle, with which each triangle of the surface makes a
  /// tetrahedron. The middle comes first, then the sides of least and largest z, then y, then x.
  static void makeShell(const XmlElement& e, const std::string& type, const std::array<std::int64_t, 3>& count,
                        Flex& flex) {
    checkCount(e, count);
    const Eigen::Vector3d spacing = spacingOf(e);
    flex.points.emplace_back(Eigen::Vector3d::Zero());
    std::map<std::array<std::int64_t, 3>, std::int32_t> vertexAt;
    const auto project = [&](const std::array<std::int64_t, 3>& at) {
      Eigen::Vector3d p, size;
      for (Eigen::Index k = 0; k < 3; ++k) {
        const auto last = static_cast<double>(count[static_cast<std::size_t>(k)] - 1);
        p[k] = 2 * static_cast<double>(at[static_cast<std::size_t>(k)]) / last - 1;
        size[k] = 0.5 * spacing[k] * last;
      }
      if (type == "ellipsoid") p.normalize();
      if (type == "cylinder" && p.head<2>().norm() > 0)
        p.head<2>() *= p.head<2>().cwiseAbs().maxCoeff() / p.head<2>().norm();
      return Eigen::Vector3d(p.cwiseProduct(size));
    };
    // Of the sides across each axis, the two other axes; the first of them runs slowest.
    static constexpr std::array<std::array<std::size_t, 3>, 3> sides{{{2, 0, 1}, {1, 0, 2}, {0, 1, 2}}};
    for (const auto& [across, slow, fast] : sides)
      for (const std::int64_t level : {std::int64_t{0}, count[across] - 1})
        for (std::int64_t i = 0; i < count[slow]; ++i)
          for (std::int64_t j = 0; j < count[fast]; ++j) {
            std::array<std::int64_t, 3> at{};
            at[across] = level, at[slow] = i, at[fast] = j;
            if (vertexAt.emplace(at, static_cast<std::int32_t>(flex.points.size())).second)
              flex.points.push_back(project(at));
          }
    for (const auto& [across, slow, fast] : sides)
      for (const std::int64_t level : {std::int64_t{0}, count[across] - 1})
        for (std::int64_t i = 0; i + 1 < count[slow]; ++i)
          for (std::int64_t j = 0; j + 1 < count[fast]; ++j) {
            const auto corner = [&, across = across, slow = slow, fast = fast](std::int64_t di, std::int64_t dj) {
              std::array<std::int64_t, 3> at{};
              at[across] = level, at[slow] = i + di, at[fast] = j + dj;
              return vertexAt.at(at);
            };
            flex.tetrahedra.push_back({0, corner(0, 0), corner(1, 0), corner(1, 1)});
            flex.tetrahedra.push_back({0, corner(0, 0), corner(0, 1), corner(1, 1)});
          }
  }

  static void readPin(const XmlElement& e, bool isGrid, const std::array<std::int64_t, 3>& count,
                      std::vector<bool>& pinned) {
    e.allow({"id", "range", "grid", "gridrange"});
    const auto list = [&](const char* attribute, std::size_t size) {
      if (!e.has(attribute)) return std::vector<std::int64_t>();
      std::vector<std::int64_t> numbers = e.integers(attribute);
      if (numbers.size() % size != 0) e.fail(attribute, fmt::format("must be {} numbers, or a multiple of it", size));
      return numbers;
    };
    for (const std::int64_t id : list("id", 1))
      pinned[static_cast<std::size_t>(vertex(e, "id", id, pinned.size()))] = true;
    const std::vector<std::int64_t> ranges = list("range", 2);
    for (std::size_t i = 0; i < ranges.size(); i += 2)
      for (std::int64_t k = vertex(e, "range", ranges[i], pinned.size()),
                        last = vertex(e, "range", ranges[i + 1], pinned.size());
           k <= last; ++k)
        pinned[static_cast<std::size_t>(k)] = true;
    for (const char* attribute : {"grid", "gridrange"}) {
      const std::size_t size = attribute == std::string_view("grid") ? 3 : 6;
      const std::vector<std::int64_t> numbers = list(attribute, size);
      if (!numbers.empty() && !isGrid) e.fail(attribute, "goes with type=\"grid\"");
      for (std::size_t i = 0; i < numbers.size(); i += size) {
        for (std::size_t k = 0; k < size; ++k)
          if (numbers[i + k] < 0 || numbers[i + k] >= count[k % 3])
            e.fail(attribute, fmt::format("{} is out of the grid; must be 0 to {}", numbers[i + k], count[k % 3] - 1));
        const std::size_t high = i + size - 3;
        for (std::int64_t x = numbers[i]; x <= numbers[high]; ++x)
          for (std::int64_t y = numbers[i + 1]; y <= numbers[high + 1]; ++y)
            for (std::int64_t z = numbers[i + 2]; z <= numbers[high + 2]; ++z)
              pinned[static_cast<std::size_t>(gridVertex(count, {x, y, z}))] = true;
      }
    }
  }

  /// <edge>, <elasticity>, <contact> and <plugin> of a flex or flexcomp.
  void readForces(const XmlElement& e, Flex& flex) {
    const std::string name = e.name();
    if (name == "edge") {
      e.allow({"equality", "solref", "solimp", "stiffness", "damping"});
      if (e.has("equality") && e.text("equality") != "false")
        e.fail("equality", "constraints along edges are not in the bracket; take them out");
      if (e.real("stiffness", 0) != 0) e.fail("stiffness", "MuJoCo has it in flexes of dim 1 only");
      flex.edgeDamping = notNegative(e, "damping");
    } else if (name == "elasticity") {
      e.allow({"young", "poisson", "damping", "thickness", "elastic2d"});
      if (e.has("elastic2d") && e.text("elastic2d") != "none") e.fail("elastic2d", "goes with dim=\"2\"");
      flex.young = notNegative(e, "young");
      flex.poisson = e.real("poisson", 0);
      if (!(flex.poisson >= 0 && flex.poisson < 0.5)) e.fail("poisson", "must be >= 0 and < 0.5");
      flex.damping = notNegative(e, "damping");
    } else if (name == "contact") {
      if (e.has("passive") && e.flag("passive"))
        e.fail("passive", "contact as a force is not in the bracket; take it out");
    } else if (name == "plugin") {
      readPlugin(e, flex);
    } else {
      e.fail("is unknown here; known are edge, elasticity, contact, pin and plugin");
    }
  }
  static double notNegative(const XmlElement& e, const char* attribute) {
    const double value = e.real(attribute, 0);
    if (value < 0) e.fail(attribute, "must be >= 0");
    return value;
  }
  /// How flexes of MuJoCo before 3.3 have their elasticity.
  void readPlugin(const XmlElement& e, Flex& flex) {
    if (e.text("plugin") != "mujoco.elasticity.solid")
      e.fail("is not known; known is plugin=\"mujoco.elasticity.solid\"");
    for (const XmlElement& config : files_.children(e, "config")) {
      const std::string key = config.text("key");
      double* const known = key == "young"     ? &flex.young
                            : key == "poisson" ? &flex.poisson
                            : key == "damping" ? &flex.damping
                                               : nullptr;
      if (!known) config.fail("key", "known are young, poisson and damping");
      *known = notNegative(config, "value");
    }
    if (flex.poisson >= 0.5) e.fail("has a Poisson's ratio of 0.5 or more; must be < 0.5");
  }

  /// Drops vertices that no element has, as MuJoCo does before it shares the mass, and turns elements round.
  static void keepUsed(Flex& flex, const std::vector<bool>& pinned) {
    std::vector<std::int32_t> place(flex.points.size(), -1);
    for (const auto& tetrahedron : flex.tetrahedra)
      for (const std::int32_t own : tetrahedron) place[static_cast<std::size_t>(own)] = 0;
    std::size_t used = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i] < 0) continue;
      place[i] = static_cast<std::int32_t>(used);
      flex.points[used] = flex.points[i];
      if (pinned[i]) flex.pinned.push_back(place[i]);
      ++used;
    }
    flex.points.resize(used);
    for (auto& t : flex.tetrahedra) {
      for (std::int32_t& own : t) own = place[static_cast<std::size_t>(own)];
      const auto at = [&](std::size_t k) { return flex.points[static_cast<std::size_t>(t[k])]; };
      if ((at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) < 0) std::swap(t[2], t[3]);
    }
  }

  void add(const XmlElement& e, Flex flex) {
    if (flex.pinned.size() == flex.points.size()) return leaveOut("rigid " + e.name());
    if (!(flex.young > 0))
      e.fail(fmt::format("{} has no elasticity, and no force that would bound its step; give <elasticity young=…>",
                         inQuotes(flex.name)));
    for (std::size_t i = 0; i < flex.tetrahedra.size(); ++i) {
      const auto& t = flex.tetrahedra[i];
      const Eigen::Vector3d& a = flex.points[static_cast<std::size_t>(t[0])];
      const auto edge = [&](std::size_t k) -> Eigen::Vector3d {
        return flex.points[static_cast<std::size_t>(t[k])] - a;
      };
      if (!(edge(1).cross(edge(2)).dot(edge(3)) > 0))
        e.fail(fmt::format("{}: its tetrahedron {} has no volume", inQuotes(flex.name), i));
    }
    model_.flexes.push_back(std::move(flex));
  }

  /// A flex whose vertices are bodies that the model has.
  void readFlex(const XmlElement& e) {
    e.allow({"name", "group", "dim", "radius", "body", "vertex", "element", "texcoord", "elemtexcoord", "material",
             "rgba", "flatskin", "node", "nodecoord", "cellcount", "dof"});
    const std::int64_t dim = e.has("dim") ? e.integers("dim", 1)[0] : 2;
    if (dim != 3) return leaveOut(fmt::format("flex of dim {}", dim));
    if (e.has("node") || e.has("dof"))
      e.fail("has its freedom at nodes of a grid; the step of free vertices alone can be told");
    std::vector<std::string> names;
    const std::string list = e.text("body");
    for (std::size_t begin = list.find_first_not_of(" \t\r\n"); begin != std::string::npos;) {
      const std::size_t end = std::min(list.find_first_of(" \t\r\n", begin), list.size());
      names.push_back(list.substr(begin, end - begin));
      begin = list.find_first_not_of(" \t\r\n", end);
    }
    if (names.size() == 1) return leaveOut("rigid flex");
    if (names.empty() || !e.has("element")) e.fail("needs body and element");
    Flex flex;
    flex.name = e.text("name", fmt::format("flex{}", model_.flexes.size()).c_str());
    flex.origin = e.origin();
    if (e.has("vertex"))
      takePoints(e, "vertex", flex);
    else
      flex.points.assign(names.size(), Eigen::Vector3d::Zero());
    if (flex.points.size() != names.size())
      e.fail(fmt::format("has {} vertices and {} bodies; must be as many", flex.points.size(), names.size()));
    takeTetrahedra(e, flex);
    std::vector<bool> pinned(names.size(), false);
    std::vector<double> masses(names.size(), 0);
    for (std::size_t i = 0; i < names.size(); ++i) placeVertex(e, names[i], flex.points[i], pinned, masses, i);
    std::vector<bool> used(names.size(), false);
    for (const auto& t : flex.tetrahedra)
      for (const std::int32_t own : t) used[static_cast<std::size_t>(own)] = true;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (used[i]) flex.masses.push_back(masses[i]);
    for (const XmlElement& child : files_.children(e)) readForces(child, flex);
    keepUsed(flex, pinned);
    // A vertex of the world has no mass of its own.
    double some = 0;
    for (const double mass : flex.masses) some = std::max(some, mass);
    std::ranges::replace(flex.masses, 0.0, some);
    add(e, std::move(flex));
  }

  void placeVertex(const XmlElement& e, const std::string& name, Eigen::Vector3d& point, std::vector<bool>& pinned,
                   std::vector<double>& masses, std::size_t i) {
    if (name == "world") {
      pinned[i] = true;
      return;
    }
    const auto found =
        std::ranges::find_if(bodies_, [&](const TreeBody& one) { return one.element.text("name") == name; });
    if (found == bodies_.end()) e.fail(fmt::format("body: there is no body {}", inQuotes(name)));
    TreeBody& body = *found;
    point = body.pose(point);
    if (!body.pose.moves()) {
      pinned[i] = true;
      return;
    }
    if (body.parentMoves || body.isVertex)
      body.element.fail(fmt::format("{} is a vertex of the flex {} and {}; its step cannot be told", inQuotes(name),
                                    inQuotes(e.text("name")),
                                    body.isVertex ? "has another one" : "moves with another body"));
    body.isVertex = true;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
    Eigen::Index slides = 0;
    for (const XmlElement& child : files_.children(body.element)) {
      if (child.name() == "body" || child.name() == "freejoint")
        child.fail(fmt::format("in {}, a vertex of a flex: such a body has three slide joints alone", inQuotes(name)));
      if (child.name() == "inertial") {
        if (!child.has("mass")) child.fail("has no mass");
        masses[i] = std::max(child.real("mass", 0), leastMass_);
      }
      if (child.name() != "joint") continue;
      const auto type = giver(child, body.childClass, "type");
      if (!type || type->text("type") != "slide" || slides == 3)
        child.fail(fmt::format("in {}, a vertex of a flex: such a body has three slide joints alone", inQuotes(name)));
      const auto axis = giver(child, body.childClass, "axis");
      axes.col(slides++) = (axis ? axis->vector("axis", {}) : Eigen::Vector3d(0, 0, 1)).normalized();
      checkJoint(child, body.childClass);
    }
    constexpr double rounding = 1e-6;
    if (slides != 3 || !(axes.transpose() * axes).isIdentity(rounding))
      body.element.fail(
          fmt::format("{} is a vertex of a flex: it needs three slide joints across each other", inQuotes(name)));
    if (!(masses[i] > 0) || inertiaFromGeoms_)
      body.element.fail(fmt::format("{} is a vertex of a flex: its mass is needed, <inertial mass=…>{}", inQuotes(name),
                                    inertiaFromGeoms_ ? ", and not that of geoms" : ""));
  }

  void checkEquality(const XmlElement& e) const {
    if (e.name() != "flex" && e.name() != "flexvert" && e.name() != "flexstrain") return;
    for (const Flex& flex : model_.flexes)
      if (e.text("flex") == flex.name) e.fail("flex", "constraints of a flex are not in the bracket; take them out");
  }

  /// Actuators and tendons whose force acts on a vertex of a flex.
  void checkReach(const XmlElement& e) {
    for (const TreeBody& body : bodies_) {
      if (!body.isVertex) continue;
      std::set<std::string> names{body.element.text("name")};
      for (const XmlElement& child : files_.children(body.element)) names.insert(child.text("name"));
      names.erase("");
      const auto reaches = [&](const XmlElement& of) {
        for (const char* key : {"joint", "jointinparent", "site", "refsite", "slidersite", "cranksite", "body", "geom"})
          if (names.contains(of.text(key)))
            of.fail(key, "acts on a vertex of a flex, and its force is not in the bracket; take it out");
      };
      reaches(e);
      for (const XmlElement& child : files_.children(e)) reaches(child);
    }
  }

  fs::path file_;
  XmlFiles files_;
  FlexModel model_;
  bool degrees_ = true, dampsJointsExplicitly_ = false, stripsPath_ = false, inertiaFromGeoms_ = false, sleeps_ = false;
  double leastMass_ = 0;
  std::string eulerOrder_ = "xyz", meshFolder_, solver_ = "Newton", cone_ = "pyramidal";
  std::map<std::string, DefaultClass> defaults_;
  std::vector<TreeBody> bodies_;
  std::map<std::string, std::int64_t> left_;
  std::set<std::pair<const void*, std::string>> safelyLeftOut_;  // elements, and their attribute
  /// What is told once of all elements that give it.
  struct LeftOutOfJoints {
    std::string first;  // where
    std::size_t count = 0;
  };
  std::map<std::string, LeftOutOfJoints> leftOutOfJoints_;  // by the attribute
};

}  // namespace

std::vector<double> Flex::differentMasses() const {
  std::vector<double> all = masses;
  sortUnique(all);
  return all;
}

bool isMjcfFile(const fs::path& file) {
  const std::string begin = detail::beginOfFile(file);
  const std::string_view rest = detail::behindProlog(begin);
  constexpr std::string_view root = "<mujoco";
  return rest.starts_with(root) && rest.size() > root.size() &&
         std::string_view(" \t\r\n>/").find(rest[root.size()]) != std::string_view::npos;
}

FlexModel readFlexModel(const fs::path& file) { return MjcfReader(file).read(); }

Mesh meshOfFlexes(const FlexModel& model) {
  Mesh mesh;
  std::size_t vertices = 0;
  for (const Flex& flex : model.flexes) vertices += flex.points.size();
  mesh.X.resize(3, static_cast<Eigen::Index>(vertices));
  std::int32_t first = 0;
  std::int64_t elements = 0;
  for (const Flex& flex : model.flexes) {
    MeshBlock block{elementTypeOf<Tet4>, {}, {}};
    std::vector<ElementRef>& members = mesh.elementSets[flex.name];
    for (const auto& tetrahedron : flex.tetrahedra) {
      for (const std::int32_t vertex : tetrahedron) block.connectivity.push_back(first + vertex);
      block.ids.push_back(elements++);
      members.emplace_back(mesh.blocks.size(), members.size());
    }
    mesh.blocks.push_back(std::move(block));
    const std::vector<double> masses = flex.differentMasses();
    for (std::size_t i = 0; i < flex.points.size(); ++i) {
      const std::int32_t node = first + static_cast<std::int32_t>(i);
      mesh.X.col(node) = flex.points[i];
      mesh.nodeIds.push_back(node);
      mesh.nodeSets[flex.name].push_back(node);
      if (masses.size() == 1) continue;
      const auto group = std::ranges::lower_bound(masses, flex.masses[i]) - masses.begin();
      mesh.nodeSets[flex.massSet(static_cast<std::size_t>(group))].push_back(node);
    }
    for (const std::int32_t vertex : flex.pinned) mesh.nodeSets[flex.pinnedSet()].push_back(first + vertex);
    first += static_cast<std::int32_t>(flex.points.size());
  }
  return mesh;
}

}  // namespace ringwatch
