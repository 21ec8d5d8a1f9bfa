#include <ringwatch/app/scene/deck_scene.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/scene/deck_faces.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/formats/deck_lines.h>
#include <ringwatch/meshes/mesh_io.h>

namespace ringwatch {
namespace {

using detail::DeckKeyword;
using detail::DeckLine;
using detail::DeckLines;
using detail::inUpperCase;
using Json = nlohmann::ordered_json;

/// What is done with a keyword.
enum class DeckRule {
  mesh,       // read with the mesh
  harmless,   // no effect on the motion
  output,     // asks for results
  taken,      // below
  load,       // refused in a run; at rest it does not matter
  procedure,  // likewise
  refused     // changes the body
};
struct DeckKeywordRule {
  std::string_view name;  // without blanks, as CalculiX compares them
  DeckRule rule;
  std::string_view why = {};
};

constexpr std::string_view noContact = "contact adds stiffness that the bracket would have to know";
constexpr std::string_view noConstraint = "ties degrees of freedom to each other";
constexpr std::string_view noLaw = "there is no such law";
constexpr std::string_view noStructure = "there are solid elements only";
constexpr std::string_view notDynamic = "is no *DYNAMIC step";

/// Every keyword that is known. One that is not here is refused.
constexpr DeckKeywordRule keywordRules[] = {
    {"HEADING", DeckRule::harmless},
    {"NODE", DeckRule::mesh},
    {"ELEMENT", DeckRule::mesh},
    {"NSET", DeckRule::mesh},
    {"ELSET", DeckRule::mesh},
    {"PART", DeckRule::mesh},
    {"ENDPART", DeckRule::mesh},
    {"ASSEMBLY", DeckRule::mesh},
    {"ENDASSEMBLY", DeckRule::mesh},
    {"INSTANCE", DeckRule::mesh},
    {"ENDINSTANCE", DeckRule::mesh},
    {"ORIENTATION", DeckRule::harmless},
    {"TIMEPOINTS", DeckRule::harmless},
    {"CONTROLS", DeckRule::harmless},
    {"PREPRINT", DeckRule::harmless},
    {"PHYSICALCONSTANTS", DeckRule::harmless},
    {"CONDUCTIVITY", DeckRule::harmless},
    {"SPECIFICHEAT", DeckRule::harmless},
    {"NODEFILE", DeckRule::output},
    {"ELFILE", DeckRule::output},
    {"NODEPRINT", DeckRule::output},
    {"ELPRINT", DeckRule::output},
    {"FACEPRINT", DeckRule::output},
    {"SECTIONPRINT", DeckRule::output},
    {"CONTACTFILE", DeckRule::output},
    {"CONTACTPRINT", DeckRule::output},
    {"NODEOUTPUT", DeckRule::output},
    {"ELEMENTOUTPUT", DeckRule::output},
    {"OUTPUT", DeckRule::output},
    {"ENERGYOUTPUT", DeckRule::output},
    {"FILEFORMAT", DeckRule::output},
    {"PRINT", DeckRule::output},
    {"MONITOR", DeckRule::output},
    {"MATERIAL", DeckRule::taken},
    {"ELASTIC", DeckRule::taken},
    {"HYPERELASTIC", DeckRule::taken},
    {"DENSITY", DeckRule::taken},
    {"DAMPING", DeckRule::taken},
    {"SOLIDSECTION", DeckRule::taken},
    {"BOUNDARY", DeckRule::taken},
    {"AMPLITUDE", DeckRule::taken},
    {"INITIALCONDITIONS", DeckRule::taken},
    {"STEP", DeckRule::taken},
    {"ENDSTEP", DeckRule::taken},
    {"DYNAMIC", DeckRule::taken},
    {"CLOAD", DeckRule::taken},
    {"DLOAD", DeckRule::taken},
    {"DSLOAD", DeckRule::taken},
    {"SURFACE", DeckRule::taken},
    {"STATIC", DeckRule::procedure, notDynamic},
    {"FREQUENCY", DeckRule::procedure, notDynamic},
    {"COMPLEXFREQUENCY", DeckRule::procedure, notDynamic},
    {"BUCKLE", DeckRule::procedure, notDynamic},
    {"MODALDYNAMIC", DeckRule::procedure, notDynamic},
    {"STEADYSTATEDYNAMICS", DeckRule::procedure, notDynamic},
    {"SENSITIVITY", DeckRule::procedure, notDynamic},
    {"GREEN", DeckRule::procedure, notDynamic},
    {"SUBSTRUCTUREGENERATE", DeckRule::procedure, notDynamic},
    {"NOANALYSIS", DeckRule::procedure, notDynamic},
    {"VISCO", DeckRule::procedure, notDynamic},
    {"HEATTRANSFER", DeckRule::procedure, "there are no temperatures"},
    {"COUPLEDTEMPERATURE-DISPLACEMENT", DeckRule::procedure, "there are no temperatures"},
    {"UNCOUPLEDTEMPERATURE-DISPLACEMENT", DeckRule::procedure, "there are no temperatures"},
    {"MODALDAMPING", DeckRule::load, "damping by modes goes with no *DYNAMIC step"},
    {"SELECTCYCLICSYMMETRYMODES", DeckRule::load, notDynamic},
    {"RETAINEDNODALDOFS", DeckRule::load, notDynamic},
    {"SUBSTRUCTUREMATRIXOUTPUT", DeckRule::load, notDynamic},
    {"DESIGNVARIABLES", DeckRule::load, notDynamic},
    {"OBJECTIVE", DeckRule::load, notDynamic},
    {"TEMPERATURE", DeckRule::load, "there are no temperatures"},
    {"CFLUX", DeckRule::load, "there are no temperatures"},
    {"DFLUX", DeckRule::load, "there are no temperatures"},
    {"FILM", DeckRule::load, "there are no temperatures"},
    {"RADIATE", DeckRule::load, "there are no temperatures"},
    {"RESTART", DeckRule::load, "a run of another program cannot be gone on with"},
    {"EXPANSION", DeckRule::load, "there are no temperatures"},
    {"PLASTIC", DeckRule::refused, noLaw},
    {"CREEP", DeckRule::refused, noLaw},
    {"CYCLICHARDENING", DeckRule::refused, noLaw},
    {"DEFORMATIONPLASTICITY", DeckRule::refused, noLaw},
    {"HYPERFOAM", DeckRule::refused, noLaw},
    {"USERMATERIAL", DeckRule::refused, noLaw},
    {"DEPVAR", DeckRule::refused, noLaw},
    {"CONTACTPAIR", DeckRule::refused, noContact},
    {"SURFACEINTERACTION", DeckRule::refused, noContact},
    {"SURFACEBEHAVIOR", DeckRule::refused, noContact},
    {"FRICTION", DeckRule::refused, noContact},
    {"TIE", DeckRule::refused, noConstraint},
    {"EQUATION", DeckRule::refused, noConstraint},
    {"MPC", DeckRule::refused, noConstraint},
    {"RIGIDBODY", DeckRule::refused, noConstraint},
    {"COUPLING", DeckRule::refused, noConstraint},
    {"DISTRIBUTINGCOUPLING", DeckRule::refused, noConstraint},
    {"CYCLICSYMMETRYMODEL", DeckRule::refused, noConstraint},
    {"PRE-TENSIONSECTION", DeckRule::refused, noConstraint},
    {"TRANSFORM", DeckRule::refused, "turns the axes of nodes"},
    {"SHELLSECTION", DeckRule::refused, noStructure},
    {"BEAMSECTION", DeckRule::refused, noStructure},
    {"BEAMGENERALSECTION", DeckRule::refused, noStructure},
    {"MEMBRANESECTION", DeckRule::refused, noStructure},
    {"FLUIDSECTION", DeckRule::refused, noStructure},
    {"SPRING", DeckRule::refused, noStructure},
    {"DASHPOT", DeckRule::refused, noStructure},
    {"MASS", DeckRule::refused, noStructure},
    {"GAP", DeckRule::refused, noStructure},
};

std::string withoutBlanks(std::string name) {
  std::erase(name, ' ');
  return name;
}

const DeckKeywordRule* findKeywordRule(std::string_view name) {
  const auto* found = std::ranges::find(keywordRules, name, &DeckKeywordRule::name);
  return found == std::end(keywordRules) ? nullptr : found;
}

/// A solid element of a deck and the quadrature that CalculiX gives it (user's manual, "Element types").
struct DeckSolid {
  std::string_view type;
  std::string_view element;  // ours; "" where no element of ours is it
  std::string_view rule;
  std::string_view why = {};
};
constexpr DeckSolid solids[] = {
    {"C3D4", "tet4", "gauss-1"},
    {"C3D6", "wedge6", "fierz2013"},
    {"C3D8", "hex8", "gauss-2x2x2"},
    {"C3D10", "tet10", "keast-4"},
    {"C3D20", "hex20", "gauss-3x3x3"},
    {"C3D20R", "hex20", "gauss-2x2x2"},
    {"C3D8R", "", "", "its hourglass control is not ours"},
    {"C3D8I", "", "", "its incompatible modes are not ours"},
    {"C3D10T", "", "", "there is no such element"},
    {"C3D15", "", "", "there is no such element"},
};

/// What is held or moved of a degree of freedom by a line of *BOUNDARY.
struct DeckBoundary {
  std::string selection;       // a set, or "#12"
  std::string components;      // "xy"
  double value = 0;            // m, or m/s
  bool velocity = false;       // value is one
  std::string amplitude = {};  // upper case
  std::size_t position = 0;
};
struct DeckLoad {
  std::string selection;
  Eigen::Vector3d value;  // N at each node, m/s² with `acceleration`
  bool acceleration = false;
  std::string amplitude = {};
  std::size_t position = 0;
};
/// A pressure on faces, each a face of DeckFaces.
struct DeckPressure {
  double value;  // Pa, inwards
  std::string amplitude;
  std::size_t position;  // of the keyword
  std::vector<std::int32_t> faces = {};
};
/// A line of a *SURFACE of element faces.
struct DeckSurfaceLine {
  std::string elements;  // a set or a number
  int face;
};
struct DeckInitial {
  std::string selection;
  Eigen::Vector3d velocity;
  std::size_t position;
};
struct DeckMaterial {
  std::string name;
  std::size_t position;
  std::optional<std::pair<double, double>> elastic;  // Young's modulus (Pa), Poisson's ratio
  std::optional<double> density;
  std::optional<std::pair<double, double>> damping;  // of mass (1/s) and stiffness (s)
  std::size_t hyperelastic = 0, dampingAt = 0;       // positions of the keywords
  std::string hyperelasticType = {};
};
struct DeckSection {
  std::string elset, part, material;
  std::size_t position;
};
struct DeckAmplitude {
  std::vector<double> times, values;
  std::size_t position;
};

class DeckReader {
 public:
  DeckReader(const std::filesystem::path& file, DeckUse use)
      : file_(file), use_(use), text_(detail::readWholeFile(file)), lines_(file, text_) {}

  DeckScene read() {
    while (const std::optional<DeckLine> line = lines_.next()) {
      if (line->isKeyword()) {
        finishKeyword();
        begin(lines_.keyword(*line));
      } else {
        data(*line);
      }
    }
    finishKeyword();
    if (!refused_.empty()) refuseAll();
    scene_.sections["mesh"] = Json{{"file", file_.filename().string()}};
    scene_.origins["mesh"] = file_.string();
    writeMaterials();
    writeIntegrator();
    writeBoundaries();
    writeInitials();
    writeLoads();
    writePressures();
    for (const auto& [name, surface] : surfaces_)
      if (!surface.used) leaveOut(surface.keyword);
    if (!left_.empty()) note(fmt::format("{}: left out, they change no motion: {}", file_.string(), left_));
    return std::move(scene_);
  }

 private:
  enum class Reading {
    nothing,
    elastic,
    hyperelastic,
    density,
    boundary,
    amplitude,
    initial,
    dynamic,
    cload,
    dload,
    dsload,
    surface
  };

  bool forRun() const { return use_ == DeckUse::run; }
  void note(std::string text) { scene_.notes.push_back(std::move(text)); }
  void refuse(std::size_t position, const std::string& what) {
    refused_.push_back(fmt::format("{}: {}", lines_.where(position), what));
  }
  [[noreturn]] void refuseAll() const {
    std::string text = refused_.front();
    constexpr std::size_t shown = 8;
    if (refused_.size() > 1) text += fmt::format("; and {} more: ", refused_.size() - 1);
    for (std::size_t i = 1; i < std::min(refused_.size(), shown); ++i) text += (i == 1 ? "" : "; ") + refused_[i];
    if (refused_.size() > shown) text += "; …";
    throw InputError(text);
  }
  void leaveOut(const DeckKeyword& keyword) {
    left_ += fmt::format("{}*{} ({})", left_.empty() ? "" : ", ", keyword.name, placeOf(keyword.position));
  }
  /// "line 12", with the file where it is an included one.
  std::string placeOf(std::size_t position) const {
    const std::string where = lines_.where(position), own = file_.string() + ":";
    return where.starts_with(own) ? "line " + where.substr(own.size()) : where;
  }

  void begin(DeckKeyword keyword) {
    keyword_ = std::move(keyword);
    reading_ = Reading::nothing;
    dataLines_ = 0;
    const std::string name = withoutBlanks(keyword_.name);
    const DeckKeywordRule* rule = findKeywordRule(name);
    if (rule == nullptr) {
      refuse(keyword_.position, fmt::format("*{} is not known", shortened(keyword_.name)));
      return;
    }
    switch (rule->rule) {
      case DeckRule::mesh:
        meshKeyword(name);
        break;
      case DeckRule::harmless:
      case DeckRule::output:
        leaveOut(keyword_);
        break;
      case DeckRule::load:
      case DeckRule::procedure:
        if (forRun())
          refuse(keyword_.position, fmt::format("*{}: {}", keyword_.name, rule->why));
        else
          leaveOut(keyword_);
        break;
      case DeckRule::refused:
        refuse(keyword_.position, fmt::format("*{}: {}", keyword_.name, rule->why));
        break;
      case DeckRule::taken:
        take(name);
        break;
    }
  }

  void meshKeyword(const std::string& name) {
    const auto remember = [&](std::map<std::string, std::string>& names, const char* key) {
      if (const std::string set = keyword_.value(key); !set.empty()) names.try_emplace(partKey(set), set);
    };
    if (name == "NODE" || name == "NSET") remember(nodeSets_, "NSET");
    if (name == "ELEMENT" || name == "ELSET") remember(elementSets_, "ELSET");
    if (name == "PART") part_ = inUpperCase(keyword_.value("NAME"));
    if (name == "ENDPART") part_.clear();
    if (name == "INSTANCE") {
      part_ = inUpperCase(keyword_.value("PART"));
      instances_.emplace_back(keyword_.value("NAME"), part_);
    }
    if (name == "ENDINSTANCE") part_.clear();
    if (name == "ELEMENT") elementType(inUpperCase(keyword_.value("TYPE")));
  }
  /// The name of a set of the part that is being read.
  std::string partKey(const std::string& set) const {
    return part_.empty() ? inUpperCase(set) : part_ + "/" + inUpperCase(set);
  }

  void elementType(const std::string& type) {
    const auto* solid = std::ranges::find(solids, type, &DeckSolid::type);
    if (solid == std::end(solids)) {
      refuse(keyword_.position, fmt::format("*ELEMENT, TYPE={}: {}", shortened(type), noStructure));
    } else if (solid->element.empty()) {
      refuse(keyword_.position, fmt::format("*ELEMENT, TYPE={}: {}", type, solid->why));
    } else {
      const auto [known, isNew] = rules_.try_emplace(std::string(solid->element), solid->rule);
      if (!isNew && known->second != solid->rule)
        refuse(keyword_.position, fmt::format("*ELEMENT, TYPE={}: a {} above has another quadrature; one is for all",
                                              type, solid->element));
    }
  }

  void take(const std::string& name) {
    const auto refuseHere = [&](const std::string& what) {
      refuse(keyword_.position, fmt::format("*{}{}", keyword_.name, what));
    };
    DeckMaterial* material = materials_.empty() ? nullptr : &materials_.back();
    const bool ofMaterial = name == "ELASTIC" || name == "HYPERELASTIC" || name == "DENSITY" || name == "DAMPING";
    if (ofMaterial && material == nullptr) return refuseHere(" stands before any *MATERIAL");
    if (name == "MATERIAL") {
      if (keyword_.value("NAME").empty()) return refuseHere(" needs a name, NAME=");
      materials_.push_back({keyword_.value("NAME"), keyword_.position, {}, {}, {}});
    } else if (name == "ELASTIC") {
      const std::string type = inUpperCase(keyword_.value("TYPE"));
      if (!type.empty() && type != "ISO" && type != "ISOTROPIC")
        return refuseHere(fmt::format(", TYPE={}: {}", shortened(type), noLaw));
      reading_ = Reading::elastic;
    } else if (name == "HYPERELASTIC") {
      for (const auto& parameter : keyword_.parameters) material->hyperelasticType = parameter.first;
      material->hyperelastic = keyword_.position;
      if (forRun())
        return refuseHere(
            ", the energy of CalculiX, of strain without its volume part, is none of the laws here; give "
            "a scene with the law that is meant");
      reading_ = Reading::hyperelastic;
    } else if (name == "DENSITY") {
      reading_ = Reading::density;
    } else if (name == "DAMPING") {
      const auto share = [&](const char* key) {
        return keyword_.has(key) ? lines_.real(keyword_.value(key), key, keyword_.position) : 0.0;
      };
      material->damping = {share("ALPHA"), share("BETA")};
      material->dampingAt = keyword_.position;
    } else if (name == "SOLIDSECTION") {
      if (keyword_.value("ELSET").empty() || keyword_.value("MATERIAL").empty())
        return refuseHere(" needs ELSET= and MATERIAL=");
      sections_.push_back({keyword_.value("ELSET"), part_, inUpperCase(keyword_.value("MATERIAL")), keyword_.position});
    } else if (name == "BOUNDARY") {
      if (!ofFirstStep()) return;
      for (const char* key : {"USER", "SUBMODEL", "FIXED", "LOADCASE"})
        if (keyword_.has(key)) return refuseHere(fmt::format(", {} is not taken", key));
      const std::string type = inUpperCase(keyword_.value("TYPE"));
      if (!type.empty() && type != "DISPLACEMENT" && type != "VELOCITY")
        return refuseHere(fmt::format(", TYPE={} is not taken", shortened(type)));
      reading_ = Reading::boundary;
    } else if (name == "AMPLITUDE") {
      beginAmplitude();
    } else if (name == "INITIALCONDITIONS") {
      const std::string type = inUpperCase(keyword_.value("TYPE"));
      if (type == "VELOCITY")
        reading_ = Reading::initial;
      else if (forRun())
        refuseHere(fmt::format(", TYPE={}: only velocities are taken", shortened(type)));
      else
        leaveOut(keyword_);
    } else if (name == "STEP") {
      ++steps_;
      inStep_ = true;
      if (steps_ == 1) {
        step_ = keyword_;
        nonlinear_ = keyword_.has("NLGEOM") && inUpperCase(keyword_.value("NLGEOM")) != "NO";
      } else if (forRun()) {
        refuseHere(": a second step; a run has one");
      }
    } else if (name == "ENDSTEP") {
      inStep_ = false;
    } else if (name == "DYNAMIC") {
      if (!ofFirstStep()) return;
      dynamic_ = keyword_;
      reading_ = Reading::dynamic;
    } else if (name == "SURFACE") {
      const std::string type = inUpperCase(keyword_.value("TYPE"));
      if (!type.empty() && type != "ELEMENT") return leaveOut(keyword_);
      surface_ = &surfaces_[inUpperCase(keyword_.value("NAME"))];
      *surface_ = {keyword_, {}};
      reading_ = Reading::surface;
    } else if (name == "CLOAD" || name == "DLOAD" || name == "DSLOAD") {
      if (!forRun()) return leaveOut(keyword_);
      for (const char* key : {"USER", "SUBMODEL", "LOADCASE", "OMEGA0", "SECTOR"})
        if (keyword_.has(key)) return refuseHere(fmt::format(", {} is not taken", key));
      reading_ = name == "CLOAD" ? Reading::cload : name == "DLOAD" ? Reading::dload : Reading::dsload;
    }
  }
  /// Before all steps, or in the first.
  bool ofFirstStep() const { return steps_ < 2; }

  void beginAmplitude() {
    const std::string name = inUpperCase(keyword_.value("NAME"));
    if (name.empty()) return refuse(keyword_.position, "*AMPLITUDE needs a name, NAME=");
    for (const auto& [key, value] : keyword_.parameters) {
      const bool known = key == "NAME" || (key == "TIME" && inUpperCase(value).starts_with("TOTAL")) ||
                         (key == "DEFINITION" && inUpperCase(value) == "TABULAR") ||
                         (key == "VALUE" && inUpperCase(value) == "RELATIVE");
      if (!known && forRun())
        return refuse(keyword_.position, fmt::format("*AMPLITUDE, {}{}{} is not taken; tables are", shortened(key),
                                                     value.empty() ? "" : "=", shortened(value)));
    }
    amplitude_ = &amplitudes_[name];
    *amplitude_ = {{}, {}, keyword_.position};
    reading_ = Reading::amplitude;
  }

  void data(const DeckLine& line) {
    const auto words = DeckLines::fields(line.text);
    ++dataLines_;
    switch (reading_) {
      case Reading::nothing:
        return;
      case Reading::elastic:
        return elastic(words, line.position);
      case Reading::hyperelastic:
        return hyperelastic(words, line.position);
      case Reading::density:
        if (!onlyOneLine(line.position)) return;
        materials_.back().density = lines_.real(words[0], "the density", line.position);
        return;
      case Reading::boundary:
        return boundary(words, line.position);
      case Reading::amplitude:
        for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
          amplitude_->times.push_back(lines_.real(words[i], "a time of the amplitude", line.position));
          amplitude_->values.push_back(lines_.real(words[i + 1], "a value of the amplitude", line.position));
        }
        return;
      case Reading::initial:
        return initial(words, line.position);
      case Reading::dynamic:
        if (dataLines_ == 1)
          for (std::size_t i = 0; i < words.size(); ++i)
            times_.push_back(words[i].empty() ? 0 : lines_.real(words[i], "a time of *DYNAMIC", line.position));
        return;
      case Reading::cload:
        return cload(words, line.position);
      case Reading::dload:
        return dload(words, line.position);
      case Reading::dsload:
        return dsload(words, line.position);
      case Reading::surface:
        if (words.size() > 1)
          if (const auto face = faceOf(words[1], 'S')) surface_->lines.push_back({std::string(words[0]), *face});
        return;
    }
  }
  /// Further lines are values at other temperatures.
  bool onlyOneLine(std::size_t position) {
    if (dataLines_ > 1)
      refuse(position, fmt::format("*{}: values that depend on temperature; there are none here", keyword_.name));
    return dataLines_ == 1;
  }
  void finishKeyword() {
    if (reading_ == Reading::elastic && !materials_.back().elastic)
      refuse(keyword_.position, "*ELASTIC has no line of data");
    if (reading_ == Reading::density && !materials_.back().density)
      refuse(keyword_.position, "*DENSITY has no line of data");
    reading_ = Reading::nothing;
  }

  void elastic(const std::vector<std::string_view>& words, std::size_t position) {
    if (!onlyOneLine(position)) return;
    if (words.size() < 2)
      lines_.failAt(position, "*ELASTIC has one number; it must have Young's modulus and Poisson's ratio");
    materials_.back().elastic = {lines_.real(words[0], "Young's modulus", position),
                                 lines_.real(words[1], "Poisson's ratio", position)};
  }
  /// At rest all that counts of a hyperelastic law are its moduli: μ = 2 (C10 + C01), K = 2/D1.
  void hyperelastic(const std::vector<std::string_view>& words, std::size_t position) {
    if (!onlyOneLine(position)) return;
    DeckMaterial& material = materials_.back();
    const bool neoHooke = material.hyperelasticType == "NEO HOOKE",
               mooney = material.hyperelasticType == "MOONEY-RIVLIN";
    const std::size_t needed = neoHooke ? 2 : 3;
    if ((!neoHooke && !mooney) || words.size() < needed)
      return refuse(material.hyperelastic,
                    fmt::format("*HYPERELASTIC, {}: only NEO HOOKE and MOONEY-RIVLIN with their D1 are taken at rest",
                                shortened(material.hyperelasticType)));
    double mu = 0;
    for (std::size_t i = 0; i + 1 < needed; ++i)
      mu += 2 * lines_.real(words[i], "a constant of *HYPERELASTIC", position);
    const double d1 = lines_.real(words[needed - 1], "D1 of *HYPERELASTIC", position);
    if (!(d1 > 0) || !(mu > 0))
      return refuse(material.hyperelastic, "*HYPERELASTIC: μ and D1 must be > 0; an incompressible body has no step");
    const double bulk = 2 / d1;
    material.elastic = {9 * bulk * mu / (3 * bulk + mu), (3 * bulk - 2 * mu) / (2 * (3 * bulk + mu))};
  }

  /// A set by its name as the mesh has it, or "#12" for a node.
  std::string selectionOf(std::string_view word) {
    if (!word.empty() && std::isdigit(static_cast<unsigned char>(word.front()))) return "#" + std::string(word);
    const auto known = nodeSets_.find(inUpperCase(word));
    return known == nodeSets_.end() ? std::string(word) : known->second;
  }
  /// A degree of freedom; empty for one that a solid has not, which is refused unless it is a rotation.
  std::optional<int> componentOf(std::string_view word, std::size_t position) {
    const std::int64_t dof = lines_.number(word, "a degree of freedom", position);
    if (dof <= 3) return static_cast<int>(dof) - 1;
    if (dof > 6)
      refuse(position,
             fmt::format("*{}: degree of freedom {} is none of a solid's; 1, 2 and 3 are", keyword_.name, dof));
    return std::nullopt;
  }

  void boundary(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 2) lines_.failAt(position, "*BOUNDARY needs a node or set and a degree of freedom");
    DeckBoundary held;
    held.selection = selectionOf(words[0]);
    held.position = position;
    static constexpr std::pair<std::string_view, std::string_view> named[] = {
        {"ENCASTRE", "xyz"}, {"PINNED", "xyz"}, {"XSYMM", "x"}, {"YSYMM", "y"}, {"ZSYMM", "z"}};
    const std::string word = inUpperCase(words[1]);
    if (const auto* known = std::ranges::find(named, word, [](const auto& entry) { return entry.first; });
        known != std::end(named)) {
      held.components = known->second;
      boundaries_.push_back(held);
      return;
    }
    const std::int64_t first = lines_.number(words[1], "the first degree of freedom", position);
    const std::int64_t last =
        words.size() > 2 && !words[2].empty() ? lines_.number(words[2], "the last degree of freedom", position) : first;
    constexpr std::int64_t temperature = 11;
    if (first == temperature && last == temperature && !forRun()) {
      if (noted_.insert(fmt::format("temperature {}", keyword_.position)).second) leaveOut(keyword_);
      return;
    }
    if (last > 6 || first > last)
      return refuse(position, fmt::format("*BOUNDARY: degrees of freedom {} to {}; a solid has 1 to 3", first, last));
    for (std::int64_t dof = first; dof <= std::min<std::int64_t>(last, 3); ++dof)
      held.components += static_cast<char>('x' + (dof - 1));
    if (words.size() > 3 && !words[3].empty()) held.value = lines_.real(words[3], "the value", position);
    held.velocity = inUpperCase(keyword_.value("TYPE")) == "VELOCITY";
    held.amplitude = inUpperCase(keyword_.value("AMPLITUDE"));
    if (!held.components.empty()) boundaries_.push_back(held);
  }

  void initial(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 3) lines_.failAt(position, "an initial velocity needs a node or set, 1, 2 or 3, and its value");
    const std::optional<int> component = componentOf(words[1], position);
    if (!component) return;
    DeckInitial start{selectionOf(words[0]), Eigen::Vector3d::Zero(), position};
    start.velocity[*component] = lines_.real(words[2], "the velocity", position);
    initials_.push_back(start);
  }

  void cload(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 3) lines_.failAt(position, "*CLOAD needs a node or set, 1, 2 or 3, and a force");
    const std::optional<int> component = componentOf(words[1], position);
    if (!component) return refuse(position, "*CLOAD: a moment; a solid's nodes have forces");
    DeckLoad load{selectionOf(words[0]), Eigen::Vector3d::Zero()};
    load.value[*component] = lines_.real(words[2], "the force", position);
    load.amplitude = inUpperCase(keyword_.value("AMPLITUDE"));
    load.position = position;
    loads_.push_back(load);
  }

  void dload(const std::vector<std::string_view>& words, std::size_t position) {
    const std::string label = words.size() > 1 ? inUpperCase(words[1]) : "";
    if (const std::optional<int> face = faceOf(label, 'P')) {
      if (words.size() < 3) lines_.failAt(position, "*DLOAD needs an element or set, a face, P1 to P6, and a pressure");
      return press(std::string(words[0]), *face, words[2], position);
    }
    static constexpr std::pair<std::string_view, std::string_view> others[] = {
        {"CENTRIF", "its force grows with the distance of a node from the axis, which no load here does"},
        {"NEWTON", "its force depends on where all other masses are, which no load here does"}};
    if (const auto* other = std::ranges::find(others, label, [](const auto& entry) { return entry.first; });
        other != std::end(others))
      return refuse(position, fmt::format("*DLOAD, {}: {}", label, other->second));
    if (label != "GRAV")
      return refuse(position,
                    fmt::format("*DLOAD, {}: of distributed loads GRAV and P1 to P6 are taken", inQuotes(label)));
    if (words.size() < 6)
      lines_.failAt(position, "GRAV needs an acceleration and the three components of its direction");
    const Eigen::Vector3d direction(lines_.real(words[3], "the direction", position),
                                    lines_.real(words[4], "the direction", position),
                                    lines_.real(words[5], "the direction", position));
    if (!ofAllElements(std::string(words[0])))
      return refuse(position, fmt::format("*DLOAD, GRAV on {}: it is taken for all elements together only, since nodes "
                                          "are shared with the others",
                                          inQuotes(words[0])));
    loads_.push_back({"", lines_.real(words[2], "the acceleration", position) * direction, true,
                      inUpperCase(keyword_.value("AMPLITUDE")), position});
  }
  const Mesh& mesh() {
    if (!mesh_) mesh_ = readMesh(file_);
    return *mesh_;
  }
  /// The number of "P3" or "S3"; empty for another word.
  static std::optional<int> faceOf(std::string_view word, char letter) {
    if (word.size() != 2 || std::toupper(static_cast<unsigned char>(word[0])) != letter || word[1] < '1' ||
        word[1] > '6')
      return std::nullopt;
    return word[1] - '0';
  }
  /// The elements of a set, or the one with that number.
  std::vector<ElementRef> elementsOf(const std::string& word, std::size_t position) {
    if (!word.empty() && std::isdigit(static_cast<unsigned char>(word.front()))) {
      const std::int64_t number = lines_.number(word, "the element", position);
      if (!instances_.empty())
        lines_.failAt(position, fmt::format("*{}: element {} of a deck of instances; give an element set",
                                            keyword_.name, number));
      for (std::size_t b = 0; b < mesh().blocks.size(); ++b)
        for (std::size_t e = 0; e < mesh().blocks[b].elementCount(); ++e)
          if (mesh().blocks[b].id(e) == number) return {{static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)}};
      lines_.failAt(position, fmt::format("*{}: the mesh has no element {}", keyword_.name, number));
    }
    for (const auto& [name, elements] : mesh().elementSets)
      if (inUpperCase(name) == inUpperCase(word)) return elements;
    lines_.failAt(position, fmt::format("*{}: there is no element set {}", keyword_.name, inQuotes(word)));
  }
  /// A pressure on a face of elements.
  void press(const std::string& elements, int face, std::string_view value, std::size_t position) {
    const double pressure = lines_.real(value, "the pressure", position);
    if (!faces_) faces_.emplace(mesh());
    if (pressures_.empty() || pressures_.back().position != keyword_.position || pressures_.back().value != pressure)
      pressures_.push_back({pressure, inUpperCase(keyword_.value("AMPLITUDE")), keyword_.position});
    for (const ElementRef element : elementsOf(elements, position)) {
      const MeshBlock& block = mesh().blocks[element.block];
      const auto named = [&] {
        return fmt::format("*{}: face {} of {} element {}", keyword_.name, face, elementInfo(block.type).name,
                           block.id(static_cast<std::size_t>(element.element)));
      };
      const std::optional<std::int32_t> found = faces_->find(element, face);
      if (!found) return refuse(position, named() + ": there is no such face");
      if (*found < 0) return refuse(position, named() + " lies inside the mesh");
      if (!pressed_.insert(*found).second)
        return refuse(position, named() + " has a pressure already; CalculiX takes the last one");
      pressures_.back().faces.push_back(*found);
    }
  }
  void dsload(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 3 || inUpperCase(words[1]) != "P")
      return refuse(position, "*DSLOAD: a line must be a surface, P, and a pressure; no other load is taken");
    const auto surface = surfaces_.find(inUpperCase(words[0]));
    if (surface == surfaces_.end())
      return refuse(position, fmt::format("*DSLOAD: there is no *SURFACE {} of element faces", inQuotes(words[0])));
    surface->second.used = true;
    for (const DeckSurfaceLine& line : surface->second.lines) press(line.elements, line.face, words[2], position);
  }
  bool ofAllElements(const std::string& elset) {
    for (const auto& [name, elements] : mesh().elementSets)
      if (inUpperCase(name) == inUpperCase(elset)) return elements.size() == mesh().elementCount();
    return false;
  }

  /// Names of an element set of a part as the mesh has them: one for each instance.
  std::vector<std::string> elementSetsOf(const DeckSection& section) const {
    const std::string key = inUpperCase(section.elset);
    const auto known = elementSets_.find(section.part.empty() ? key : section.part + "/" + key);
    const std::string name = known == elementSets_.end() ? section.elset : known->second;
    if (section.part.empty()) return {name};
    std::vector<std::string> names;
    for (const auto& [instance, part] : instances_)
      if (part == section.part)
        names.push_back(instances_.size() > 1 || elementSets_.count(key) != 0 ? instance + "." + name : name);
    return names;
  }

  void writeMaterials() {
    if (sections_.empty())
      throw InputError(fmt::format("{}: no *SOLID SECTION gives the elements a material", file_.string()));
    Json list = Json::array();
    std::vector<std::string> origins;
    const DeckMaterial* damped = nullptr;
    for (const DeckSection& section : sections_) {
      const auto material = std::ranges::find(materials_, section.material,
                                              [](const DeckMaterial& one) { return inUpperCase(one.name); });
      if (material == materials_.end())
        lines_.failAt(section.position,
                      fmt::format("*SOLID SECTION: there is no *MATERIAL {}", inQuotes(section.material)));
      if (!material->elastic)
        lines_.failAt(material->position, fmt::format("*MATERIAL {} has no *ELASTIC", inQuotes(material->name)));
      for (const std::string& set : elementSetsOf(section)) {
        Json entry{{"model", modelOf(*material)},
                   {"young", material->elastic->first},
                   {"poisson", material->elastic->second},
                   {"set", set}};
        if (material->density) entry["density"] = *material->density;
        list.push_back(std::move(entry));
        origins.push_back(lines_.where(material->position));
      }
      if (material->damping) damped = &*material;
    }
    if (damped != nullptr) {
      if (sections_.size() > 1)
        lines_.failAt(damped->dampingAt, "*DAMPING: it is of the whole body here, but there are several sections");
      scene_.sections["damping"] = Json{{"mass", damped->damping->first}, {"stiffness", damped->damping->second}};
      scene_.origins["damping"] = lines_.where(damped->dampingAt);
    }
    if (!rules_.empty()) {
      Json rules = Json::array();
      for (const auto& [element, rule] : rules_) rules.push_back(element + "=" + rule);
      list.front()["rules"] = std::move(rules);
    }
    if (list.size() == 1) {
      scene_.sections["material"] = list.front();
      scene_.origins["material"] = origins.front();
      return;
    }
    scene_.sections["material"] = std::move(list);
    for (std::size_t i = 0; i < origins.size(); ++i) scene_.origins[fmt::format("material.{}", i)] = origins[i];
  }
  std::string modelOf(const DeckMaterial& material) {
    if (material.hyperelastic > 0) {
      if (noted_.insert(material.name).second)
        note(fmt::format("{}: *HYPERELASTIC is taken by its moduli at rest, which is all that counts there",
                         lines_.where(material.hyperelastic)));
      return "linear";
    }
    return nonlinear_ ? "stvk" : "linear";
  }

  void writeIntegrator() {
    Json& integrator = scene_.sections["integrator"] = Json{{"step", "auto"}, {"end", 1.0}};
    scene_.origins["integrator"] = file_.string();
    if (!forRun()) {
      // The step that the deck asks for is one to hold against the bracket.
      if (dynamic_ && dynamic_->has("EXPLICIT") && dynamic_->has("DIRECT") && times_.size() > 1)
        integrator = Json{{"step", times_[0]}, {"end", times_[1]}};
      return;
    }
    if (!dynamic_)
      throw InputError(
          fmt::format("{}: has no *DYNAMIC step, and so no motion to run; ringwatch inspect tells the "
                      "step that its body can take",
                      file_.string()));
    const std::string where = lines_.where(dynamic_->position);
    scene_.origins["integrator"] = where;
    if (times_.size() < 2)
      throw InputError(fmt::format("{}: *DYNAMIC needs a line with its step and its length, s", where));
    integrator["end"] = times_[1];
    const bool isExplicit = dynamic_->has("EXPLICIT");
    if (isExplicit && dynamic_->has("DIRECT"))
      integrator["step"] = times_[0];
    else
      note(
          fmt::format("{}: *DYNAMIC {}: the step follows the safe step", where,
                      isExplicit ? "leaves the step to the program" : "is implicit there, and is run explicitly here"));
    note(fmt::format("{}: *STEP {}: linear elasticity is {}", lines_.where(step_.position),
                     nonlinear_ ? "with NLGEOM" : "without NLGEOM", nonlinear_ ? "stvk" : "linear"));
  }

  /// A table of the scene for an amplitude, and the factor of one with a single point. The slopes with `derivative`.
  struct Table {
    Json times = Json::array(), factors = Json::array();
    double factor = 1;
    bool any() const { return !times.empty(); }
  };
  const DeckAmplitude& amplitudeOf(const std::string& name, std::size_t position) const {
    const auto found = amplitudes_.find(name);
    if (found == amplitudes_.end()) lines_.failAt(position, fmt::format("there is no *AMPLITUDE {}", inQuotes(name)));
    if (found->second.times.empty()) lines_.failAt(found->second.position, "*AMPLITUDE has no points");
    return found->second;
  }
  bool rampsLoads() const { return inUpperCase(step_.value("AMPLITUDE")) == "RAMP"; }

  Table loadTable(const std::string& amplitude, std::size_t position) const {
    Table table;
    if (amplitude.empty()) {
      if (!rampsLoads()) return table;  // at once, as in every *DYNAMIC step
      table.times = {0.0, times_[1]};
      table.factors = {0.0, 1.0};
      return table;
    }
    const DeckAmplitude& points = amplitudeOf(amplitude, position);
    if (points.times.size() == 1) {
      table.factor = points.values[0];
      return table;
    }
    table.times = points.times;
    table.factors = points.values;
    return table;
  }
  /// Of a displacement that is value × amplitude: the factors of its velocity, constant between two times.
  Table velocityTable(const DeckBoundary& held) const {
    std::vector<double> times{0, times_[1]}, values{0, 1};
    std::size_t position = held.position;
    if (!held.amplitude.empty()) {
      const DeckAmplitude& points = amplitudeOf(held.amplitude, held.position);
      times = points.times;
      values = points.values;
      position = points.position;
    } else if (!rampsLoads()) {
      lines_.failAt(held.position, "*BOUNDARY: the nodes would jump to their place at once; give an AMPLITUDE from 0");
    }
    if (times.size() < 2 || values[0] != 0)
      lines_.failAt(position,
                    "*AMPLITUDE of a displacement must have two points and more and begin with 0, or the "
                    "nodes would jump to their place at once");
    Table table;
    if (times.size() == 2 && times[0] <= 0 && times[1] >= times_[1]) {
      table.factor = (values[1] - values[0]) / (times[1] - times[0]);
      return table;
    }
    if (times[0] > 0) {
      table.times.push_back(0.0);
      table.factors.push_back(0.0);
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
      table.times.push_back(times[i]);
      const bool last = i + 1 == times.size();
      if (!last && !(times[i + 1] > times[i]))
        lines_.failAt(position, fmt::format("*AMPLITUDE: the times must increase, but {} s follows {} s", times[i + 1],
                                            times[i]));
      table.factors.push_back(last ? 0.0 : (values[i + 1] - values[i]) / (times[i + 1] - times[i]));
    }
    return table;
  }

  /// Adds an entry of a list; one that differs from the last in its nodes alone, each named by its number, joins it.
  void addEntry(const std::string& section, const std::string& selection, const Json& rest, std::size_t position) {
    Json& list = scene_.sections[section];
    if (list.is_null()) list = Json::array();
    const std::string key = rest.dump();
    if (selection.starts_with("#") && !list.empty() && lastKey_[section] == key) {
      std::string text = list.back()["set"].get<std::string>();
      if (text.starts_with("#")) {
        list.back()["set"] = text + "," + selection.substr(1);
        return;
      }
    }
    lastKey_[section] = key;
    scene_.origins[fmt::format("{}.{}", section, list.size())] = lines_.where(position);
    Json entry = selection.empty() ? Json{{"where", "all"}} : Json{{"set", selection}};
    entry.update(rest);
    list.push_back(std::move(entry));
  }
  static Json listOf(const Eigen::Vector3d& v) { return Json{v[0], v[1], v[2]}; }

  void writeBoundaries() {
    for (const DeckBoundary& held : boundaries_) {
      if (held.value == 0 || !forRun()) {
        addEntry("fix", held.selection, {{"components", held.components}}, held.position);
        continue;
      }
      Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
      for (const char c : held.components) velocity[c - 'x'] = held.value;
      const Table table = held.velocity ? loadTable(held.amplitude, held.position) : velocityTable(held);
      Json entry{{"components", held.components}, {"velocity", listOf(table.factor * velocity)}};
      if (table.any()) {
        entry["times"] = table.times;
        entry["factors"] = table.factors;
        if (!held.velocity) entry["ramp"] = "hold";
      }
      addEntry("move", held.selection, entry, held.position);
    }
  }
  void writeInitials() {
    if (!forRun()) return;
    for (const DeckInitial& start : initials_)
      addEntry("initial", start.selection, {{"velocity", listOf(start.velocity)}}, start.position);
  }
  void writeLoads() {
    for (const DeckLoad& load : loads_) {
      const Table table = loadTable(load.amplitude, load.position);
      Json entry{{load.acceleration ? "acceleration" : "each", listOf(table.factor * load.value)}};
      if (table.any()) {
        entry["times"] = table.times;
        entry["factors"] = table.factors;
      }
      addEntry("force", load.selection, entry, load.position);
    }
  }

  void writePressures() {
    if (!pressures_.empty() && !nonlinear_)
      note(fmt::format(
          "{}: the pressure follows the surface; CalculiX keeps its first direction and area without NLGEOM",
          lines_.where(pressures_.front().position)));
    for (const DeckPressure& pressure : pressures_) {
      const Table table = loadTable(pressure.amplitude, pressure.position);
      Json entry{{"pressure", table.factor * pressure.value}};
      if (table.any()) {
        entry["times"] = table.times;
        entry["factors"] = table.factors;
      }
      for (const std::string& nodes : faces_->nodeSetsOf(pressure.faces)) {
        lastKey_.erase("pressure");  // sets of two entries stay apart
        addEntry("pressure", nodes, entry, pressure.position);
      }
    }
  }

  std::filesystem::path file_;
  DeckUse use_;
  std::string text_;
  DeckLines lines_;
  DeckScene scene_;
  DeckKeyword keyword_;
  Reading reading_ = Reading::nothing;
  int dataLines_ = 0, steps_ = 0;
  bool inStep_ = false, nonlinear_ = false;
  DeckKeyword step_;
  std::optional<DeckKeyword> dynamic_;
  std::vector<double> times_;                                   // of *DYNAMIC, s
  std::string part_;                                            // that is being read, upper case
  std::vector<std::pair<std::string, std::string>> instances_;  // name, part
  std::map<std::string, std::string> nodeSets_, elementSets_;   // in upper case, PART/SET in a part -> as written
  std::map<std::string, std::string> rules_;                    // element -> quadrature rule
  std::vector<DeckMaterial> materials_;
  std::vector<DeckSection> sections_;
  std::vector<DeckBoundary> boundaries_;
  std::vector<DeckPressure> pressures_;
  std::set<std::int32_t> pressed_;
  struct Surface {
    DeckKeyword keyword;
    std::vector<DeckSurfaceLine> lines;
    bool used = false;
  };
  std::map<std::string, Surface> surfaces_;
  Surface* surface_ = nullptr;
  std::vector<DeckInitial> initials_;
  std::vector<DeckLoad> loads_;
  std::map<std::string, DeckAmplitude> amplitudes_;
  DeckAmplitude* amplitude_ = nullptr;
  std::optional<Mesh> mesh_;
  std::optional<DeckFaces> faces_;
  std::vector<std::string> refused_;
  std::set<std::string> noted_;
  std::map<std::string, std::string> lastKey_;
  std::string left_;
};

}  // namespace

bool isDeckFile(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  if (file.extension() == ".inp") return true;  // what is wrong with it its reader says
  std::ifstream stream(file, std::ios::binary);
  std::string begin(std::size_t{64} << 10, '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(stream.gcount()));
  return detail::startsWithDeck(begin);
}

std::string deckHelp() {
  const auto listed = [](DeckRule wanted) {
    std::vector<std::string> names;
    for (const DeckKeywordRule& keyword : keywordRules)
      if (keyword.rule == wanted) names.push_back("*" + std::string(keyword.name));
    return fmt::format("{}", fmt::join(names, " "));
  };
  std::string text =
      "Abaqus and CalculiX decks in place of a scene (run) or a mesh (inspect); blanks in keywords do not count, "
      "*INCLUDE is\nfollowed, and whatever is not listed is refused.\n\n";
  for (const auto& [head, rule] : {std::pair{"read with the mesh", DeckRule::mesh},
                                   {"taken", DeckRule::taken},
                                   {"left out, with a note", DeckRule::harmless},
                                   {"output requests, left out with a note", DeckRule::output}})
    text += fmt::format("{}:\n  {}\n", head, listed(rule));
  for (const auto& [head, rule] : {std::pair{"of no matter to inspect; run refuses them", DeckRule::procedure},
                                   {"likewise", DeckRule::load},
                                   {"refused", DeckRule::refused}}) {
    text += fmt::format("{}:\n", head);
    for (const DeckKeywordRule& keyword : keywordRules)
      if (keyword.rule == rule) text += fmt::format("  *{:<35} {}\n", keyword.name, keyword.why);
  }
  text += "elements (*ELEMENT, TYPE=), with the quadrature that CalculiX gives them:\n";
  for (const DeckSolid& solid : solids)
    text += solid.element.empty() ? fmt::format("  {:<8} refused: {}\n", solid.type, solid.why)
                                  : fmt::format("  {:<8} {} with {}\n", solid.type, solid.element, solid.rule);
  return text;
}

DeckScene readDeckScene(const std::filesystem::path& file, DeckUse use) { return DeckReader(file, use).read(); }

}  // namespace ringwatch
