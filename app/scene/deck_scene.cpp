#include <ringwatch/app/scene/deck_scene.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/scene/deck_writer.h>
#include <ringwatch/app/scene/dyna_scene.h>
#include <ringwatch/app/scene/toml_text.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/body.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch {
namespace {

using detail::DeckKeyword;
using detail::DeckLine;
using detail::DeckLines;
using detail::inUpperCase;
using Json = nlohmann::ordered_json;

std::string withoutBlanks(std::string name) {
  std::erase(name, ' ');
  return name;
}

/// A line of a *SURFACE.
struct DeckSurfaceLine {
  std::string elements;  // a set or a number; of nodes in a *SURFACE of those
  int face;              // 0 for all that lie outside
  std::size_t position;
};
struct DeckContact {
  std::string nodes, faces;  // of *SURFACE; "" for all
  std::string interaction;
  std::size_t position;
};
struct DeckInitial {
  std::string selection, point;
  int component;
  double velocity;  // m/s
  std::size_t position;
};
/// A form of *HYPERELASTIC, whose energy is that of the law: with the constants behind its numbers D1, D2, …, of
/// volume.
struct DeckRubber {
  std::string_view parameter, model;
  std::vector<std::string_view> constants;
  std::size_t volumes;  // how many D
};
const DeckRubber rubbers[] = {
    {"NEOHOOKE", "mooney-rivlin", {"c10"}, 1},
    {"MOONEY-RIVLIN", "mooney-rivlin", {"c10", "c01"}, 1},
    {"YEOH", "yeoh", {"c10", "c20", "c30"}, 3},
};
struct DeckMaterial {
  std::string name;
  std::size_t position = 0;
  std::optional<std::pair<double, double>> elastic;  // Young's modulus (Pa), Poisson's ratio
  const DeckRubber* form = nullptr;                  // of *HYPERELASTIC
  Json rubber;                                       // its law and constants, null without
  std::optional<double> density;
  std::optional<std::pair<double, double>> damping;                       // of mass (1/s) and stiffness (s)
  std::optional<std::size_t> lawAt = {}, densityAt = {}, dampingAt = {};  // positions of the keywords
};
/// An element of one or two nodes, whose numbers stand below another keyword.
struct DeckLinkType {
  std::string_view type, keyword;
  std::size_t nodes;
};
constexpr DeckLinkType linkTypes[] = {{"MASS", "MASS", 1},
                                      {"SPRING1", "SPRING", 1},
                                      {"SPRINGA", "SPRING", 2},
                                      {"DASHPOT1", "DASHPOT", 1},
                                      {"DASHPOTA", "DASHPOT", 2}};
struct DeckLink {
  const DeckLinkType* type;
  std::string part;
  std::vector<std::string> nodes;
  std::size_t position;
};
/// *MASS, *SPRING and *DASHPOT.
struct DeckProperty {
  std::string keyword, elset, part;
  std::size_t position;
  std::vector<std::string> numbers = {};
};
/// Lines of elements that are no solids.
struct DeckStructure {
  std::string type, elset;
  std::size_t position, count = 0;
};
struct DeckSection {
  std::string elset, part, instance, material;  // instance: the one that it stands in
  std::size_t position;
};
/// *RIGID BODY: it is held and moved at its reference node, which need not be of the mesh.
struct DeckRigid {
  DeckKeyword keyword;
  std::string point, turning;  // pointOf the reference node, and of the one that has the rotations
};
constexpr const char* severalNodes = "several";
/// *FIXED MASS SCALING: by a factor, and then for a step.
struct DeckScaling {
  std::string elset;    // "" for all that no other one is of
  double factor, step;  // s, 0 for none
  std::size_t position;
};
struct DeckAmplitude {
  std::vector<double> times, values;
  std::size_t position;
  bool smooth;  // SMOOTH STEP
};

/// Keywords that are taken and have no lines of data, in either dialect.
constexpr std::string_view withoutData[] = {"MATERIAL",           "DAMPING",           "CONTACT",
                                            "SURFACEBEHAVIOR",    "CONTACTINCLUSIONS", "FIXEDMASSSCALING",
                                            "VARIABLEMASSSCALING"};

class DeckReader : DeckWriter {
 public:
  DeckReader(const std::filesystem::path& file, DeckUse use) : DeckWriter(file, use, detail::DeckDialect::abaqus) {}

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
    if (expansion_ && temperature_)
      refuse(expansion_->position, fmt::format("*EXPANSION with the temperatures of *{} ({}): heat strains the body, "
                                               "which changes its tangent and with it the critical step",
                                               temperature_->name, placeOf(temperature_->position)));
    finishStructures();
    throwRefused();
    scene_.sections["mesh"] = Json{{"file", file_.filename().string()}};
    scene_.origins["mesh"] = file_.string();
    writeMaterials();
    writeIntegrator();
    writeRigids();
    for (const DeckBoundary& one : boundaries_)
      if (!one.components.empty()) requireOfMesh(one.selection, one.point, "*BOUNDARY", one.position);
    writeBoundaries();
    writeInitials();
    writeLinks();
    writeScaledMass();
    writeContacts();
    writeLoads();
    if (presses() && !nonlinear_)
      note(fmt::format(
          "{}: the pressure follows the surface; CalculiX keeps its first direction and area without NLGEOM",
          lines_.where(firstPressure())));
    writePressures();
    for (const auto& [name, surface] : surfaces_)
      if (!surface.used) leaveOut(surface.keyword);
    return finished();
  }

 private:
  struct Surface {
    DeckKeyword keyword;
    std::vector<DeckSurfaceLine> lines;
    bool ofNodes = false, used = false;
  };
  enum class Reading {
    nothing,
    noData,  // a line of data is refused
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
    surface,
    bulkViscosity,
    sectionControls,
    structure,
    nodeSet,
    ownNode,
    solidSection,
    link,
    property,
    interactions,
    contact,
    friction
  };

  using DeckWriter::leaveOut;
  void leaveOut(const DeckKeyword& keyword) { leaveOut(keyword.name, keyword.position); }

  void begin(DeckKeyword keyword) {
    keyword_ = std::move(keyword);
    reading_ = Reading::nothing;
    dataLines_ = 0;
    const std::string name = withoutBlanks(keyword_.name);
    for (const auto& [key, value] : keyword_.parameters) requireUtf8(key + value, keyword_.position);
    const DeckKeywordRule* rule = findKeywordRule(abaqusKeywords(), name);
    if (rule == nullptr) {
      refuse(keyword_.position, fmt::format("*{} is not known", shortened(keyword_.name)));
      return;
    }
    if (!follow(rule->rule, "", rule->why) || !takesParameters(name, rule->rule)) return;
    if (std::ranges::find(withoutData, name) != std::end(withoutData)) reading_ = Reading::noData;
    if (rule->rule == DeckRule::mesh) meshKeyword(name);
    const bool taken = isTaken(rule->rule);
    if (taken) take(name);
    if (!keyword_.has("INPUT")) return;
    if (reading_ != Reading::nothing && reading_ != Reading::noData)
      lines_.include(keyword_);
    else if (taken)
      refuse(keyword_.position, fmt::format("*{}, INPUT: it has no lines to take from a file", keyword_.name));
  }
  bool isTaken(DeckRule rule) const { return rule == DeckRule::taken || (rule == DeckRule::takenInRun && forRun()); }
  /// Names go into files of JSON.
  void requireUtf8(std::string_view text, std::size_t position) const {
    if (firstNotUtf8(text) < text.size()) lines_.failAt(position, "the line is not UTF-8; save the deck as UTF-8");
  }
  /// Does what the table says of the keyword, or of a parameter of it. False where it is refused.
  bool follow(DeckRule rule, const std::string& parameter, std::string_view why) {
    if ((rule == DeckRule::temperature || (rule == DeckRule::procedure && why == noTemperature)) && !temperature_)
      temperature_ = keyword_;
    if (rule == DeckRule::expansion && !expansion_) expansion_ = keyword_;
    const bool followed = DeckWriter::follow(rule, keyword_.name, parameter, why, keyword_.position);
    ofStructures_ = ofStructures_ || (!followed && why == noStructure);
    return followed;
  }
  /// Whether all that a keyword line says besides its name is done.
  bool takesParameters(const std::string& name, DeckRule rule) {
    const bool taken = isTaken(rule);
    bool all = true;
    for (const auto& [parameter, value] : keyword_.parameters) {
      const std::string what = fmt::format("{}{}{}", shortened(parameter), value.empty() ? "" : "=", shortened(value));
      if (const DeckParameterRule* known = findParameterRule(name, parameter, withoutBlanks(inUpperCase(value)))) {
        if (taken || known->rule == DeckRule::refused) all = follow(known->rule, what, known->why) && all;
      } else if (taken && parameter != "INPUT") {
        const std::string takes = takenParameters(name);
        refuse(keyword_.position, fmt::format("*{}, {} is not taken; {}", keyword_.name, what,
                                              takes.empty() ? "there are no parameters" : takes + " are"));
        all = false;
      }
    }
    return all;
  }

  void meshKeyword(const std::string& name) {
    const auto remember = [&](std::map<std::string, std::string>& names, const char* key) {
      if (const std::string set = keyword_.value(key); !set.empty()) names.try_emplace(partKey(set), set);
    };
    if (name == "NODE" || name == "NSET" || name == "NGEN" || name == "NFILL") remember(nodeSets_, "NSET");
    if (name == "ELEMENT" || name == "ELSET" || name == "ELGEN") remember(elementSets_, "ELSET");
    if (name == "PART") part_ = inUpperCase(keyword_.value("NAME"));
    if (name == "ENDPART") part_.clear();
    if (name == "INSTANCE") {
      instance_ = keyword_.value("NAME");
      part_ = inUpperCase(keyword_.value("PART"));
      if (part_.empty()) part_ = "." + inUpperCase(instance_);  // one of its own
      instances_.emplace_back(instance_, part_);
    }
    if (name == "ENDINSTANCE") {
      part_.clear();
      instance_.clear();
    }
    if (name == "NSET" && !keyword_.has("GENERATE") && !keyword_.has("ELSET")) reading_ = Reading::nodeSet;
    if (name == "NODE" && part_.empty() && !instances_.empty()) reading_ = Reading::ownNode;
    if (name == "ELEMENT") elementType(inUpperCase(keyword_.value("TYPE")));
  }
  /// What stands in a part without an instance is not in the model.
  bool isInstanced(const std::string& part) const {
    return part.empty() || std::ranges::any_of(instances_, [&](const auto& one) { return one.second == part; });
  }
  /// The name of a set of the part that is being read.
  std::string partKey(const std::string& set) const {
    return part_.empty() ? inUpperCase(set) : part_ + "/" + inUpperCase(set);
  }

  void elementType(const std::string& type) {
    if (const auto* link = std::ranges::find(linkTypes, type, &DeckLinkType::type); link != std::end(linkTypes)) {
      links_.try_emplace(partKey(keyword_.value("ELSET")));
      linkType_ = link;
      reading_ = Reading::link;
      return;
    }
    const DeckSolid* solid = findDeckSolid(type);
    if (solid == nullptr && !type.starts_with("C3D")) {
      structures_.push_back({shortened(type), inUpperCase(keyword_.value("ELSET")), keyword_.position});
      continued_ = false;
      reading_ = Reading::structure;
    } else if (solid == nullptr) {
      refuse(keyword_.position, fmt::format("*ELEMENT, TYPE={}: {}", shortened(type), noElement));
    } else if (solid->element.empty() || (forRun() && solid->why == cornersAlone)) {
      refuse(keyword_.position, fmt::format("*ELEMENT, TYPE={}: {}", type, solid->why));
    } else {
      if (!solid->why.empty() && noted_.insert(type).second)
        note(fmt::format("{}: *ELEMENT, TYPE={} is {} with {}: {}", lines_.where(keyword_.position), type,
                         solid->element, solid->rule, solid->why));
      const auto [known, isNew] = rules_.try_emplace(std::string(solid->element), solid->rule);
      byType_ = byType_ || known->second != solid->rule;
    }
  }

  /// Elements that are no solids are of the body where a section says so; preprocessors write the lines and faces of
  /// their geometry without.
  void finishStructures() {
    std::string without;
    for (const DeckStructure& one : structures_) {
      const std::string what = fmt::format("{} of type {}", one.count, one.type);
      // The mesh has such elements as the nodes of their sets.
      const bool named =
          ofStructures_ || std::ranges::any_of(sections_, [&](const DeckSection& section) {
            return inUpperCase(section.elset) == one.elset ||
                   (refused_.empty() && std::ranges::any_of(elementSetsOf(section), [&](const std::string& set) {
                      return !nodeSets_.contains(inUpperCase(section.elset)) && mesh().nodeSets.contains(set);
                    }));
          });
      if (named)
        refuse(one.position, fmt::format("*ELEMENT, TYPE={}: {} element{}: {}", one.type, one.count,
                                         one.count == 1 ? "" : "s", noStructure));
      else
        without += fmt::format("{}{} ({})", without.empty() ? "" : ", ", what, placeOf(one.position));
    }
    if (!without.empty())
      note(
          fmt::format("{}: elements that are no solids and that no section makes part of the body: {}; the sets of "
                      "their nodes stay",
                      file_.string(), without));
  }

  void take(const std::string& name) {
    const auto refuseHere = [&](const std::string& what) {
      refuse(keyword_.position, fmt::format("*{}{}", keyword_.name, what));
    };
    DeckMaterial* material = materials_.empty() ? nullptr : &materials_.back();
    const bool ofMaterial = name == "ELASTIC" || name == "HYPERELASTIC" || name == "DENSITY" || name == "DAMPING";
    if (ofMaterial && material == nullptr) return refuseHere(" stands before any *MATERIAL");
    if (!inStep_ && (name == "DYNAMIC" || name == "CLOAD" || name == "DLOAD" || name == "DSLOAD"))
      return refuseHere(" stands outside a step; it belongs between *STEP and *END STEP");
    if (!part_.empty() && (name == "BOUNDARY" || name == "INITIALCONDITIONS" || name == "RIGIDBODY"))
      return refuseHere(" stands in a *PART or *INSTANCE; write it behind the assembly, for the set INSTANCE.SET");
    if (name == "MATERIAL") {
      if (keyword_.value("NAME").empty()) return refuseHere(" needs a name, NAME=");
      for (const DeckMaterial& one : materials_)
        if (inUpperCase(one.name) == inUpperCase(keyword_.value("NAME"))) refuseSecond(one.position);
      materials_.emplace_back();
      materials_.back().name = keyword_.value("NAME");
      materials_.back().position = keyword_.position;
    } else if (name == "ELASTIC") {
      if (!firstOf(material->lawAt)) return;
      reading_ = Reading::elastic;
    } else if (name == "HYPERELASTIC") {
      if (!firstOf(material->lawAt)) return;
      const auto isNamed = [&](const DeckRubber& r) { return keyword_.has(std::string(r.parameter)); };
      if (std::ranges::count_if(rubbers, isNamed) > 1) return refuseHere(" names two energies; one is of a material");
      const auto* form = std::ranges::find_if(rubbers, isNamed);
      if (form == std::end(rubbers)) return refuseHere(": NEO HOOKE, MOONEY-RIVLIN and YEOH with their D1 are taken");
      material->form = form;
      reading_ = Reading::hyperelastic;
    } else if (name == "DENSITY") {
      if (!firstOf(material->densityAt)) return;
      reading_ = Reading::density;
    } else if (name == "DAMPING") {
      if (!firstOf(material->dampingAt)) return;
      const auto share = [&](const char* key) {
        return keyword_.has(key) ? lines_.real(keyword_.value(key), key, keyword_.position) : 0.0;
      };
      material->damping = {share("ALPHA"), share("BETA")};
    } else if (name == "BULKVISCOSITY") {
      if (!ofFirstStep() || !firstOf(viscosityAt_)) return;
      scene_.sections["damping"]["bulk_viscosity"] = true;  // without numbers with those of Abaqus, which are ours
      scene_.origins["damping"] = lines_.where(keyword_.position);
      reading_ = Reading::bulkViscosity;
    } else if (name == "FIXEDMASSSCALING" || name == "VARIABLEMASSSCALING") {
      if (ofFirstStep()) scaleMass();
    } else if (name == "SECTIONCONTROLS") {
      reading_ = Reading::sectionControls;
    } else if (name == "SOLIDSECTION") {
      if (keyword_.value("ELSET").empty() || keyword_.value("MATERIAL").empty())
        return refuseHere(" needs ELSET= and MATERIAL=");
      sections_.push_back(
          {keyword_.value("ELSET"), part_, instance_, inUpperCase(keyword_.value("MATERIAL")), keyword_.position});
      reading_ = Reading::solidSection;
    } else if (name == "MASS" || name == "SPRING" || name == "DASHPOT") {
      if (keyword_.value("ELSET").empty()) return refuseHere(" needs ELSET=");
      properties_.push_back({name, keyword_.value("ELSET"), part_, keyword_.position});
      reading_ = Reading::property;
    } else if (name == "RIGIDBODY") {
      if (!keyword_.has("REFNODE")) return refuseHere(" needs REF NODE=");
      const std::string point = pointOf(keyword_.value("REFNODE"));
      if (point.empty()) return refuseHere(": REF NODE must be a node, or a set of one node");
      rigids_.push_back({keyword_, point, keyword_.has("ROTNODE") ? pointOf(keyword_.value("ROTNODE")) : point});
    } else if (name == "BOUNDARY") {
      if (!ofFirstStep()) return;
      if (inUpperCase(keyword_.value("OP")) == "NEW" && !boundaries_.empty())
        return refuseHere(", OP=NEW: lets go of what is held above; leave that out instead");
      reading_ = Reading::boundary;
    } else if (name == "AMPLITUDE") {
      if (keyword_.value("NAME").empty()) return refuseHere(" needs a name, NAME=");
      const auto [entry, isNew] = amplitudes_.try_emplace(inUpperCase(keyword_.value("NAME")));
      if (!isNew) return refuseSecond(entry->second.position);
      amplitude_ = &entry->second;
      *amplitude_ = {
          {},
          {},
          keyword_.position,
          keyword_.has("DEFINITION") && withoutBlanks(inUpperCase(keyword_.value("DEFINITION"))) == "SMOOTHSTEP"};
      reading_ = Reading::amplitude;
    } else if (name == "INITIALCONDITIONS") {
      if (keyword_.value("TYPE").empty()) return refuseHere(" needs a type, TYPE=");
      if (inUpperCase(keyword_.value("TYPE")) != "VELOCITY") return;
      if (!forRun()) return leaveOut(keyword_);
      reading_ = Reading::initial;
    } else if (name == "STEP") {
      ++steps_;
      inStep_ = true;
      if (steps_ == 1) {
        step_ = keyword_;
        nonlinear_ = isOn(keyword_, "NLGEOM");
        const std::string word = inUpperCase(keyword_.value("NLGEOM"));
        if (!word.empty() && word != "YES" && word != "NO")
          refuseHere(fmt::format(", NLGEOM={}: YES and NO are taken", shortened(word)));
      } else if (forRun()) {
        refuseHere(": a second step; a run has one");
      } else if (steps_ == 2) {
        note(
            fmt::format("{}: *STEP: this step and what follows it are left out; they begin with what the first step "
                        "leaves, and the critical step here is that of the body at rest",
                        lines_.where(keyword_.position)));
      }
    } else if (name == "ENDSTEP") {
      inStep_ = false;
    } else if (name == "DYNAMIC") {
      if (!ofFirstStep()) return;
      if (dynamic_) return refuseHere(": the step has one already");
      dynamic_ = keyword_;
      reading_ = Reading::dynamic;
    } else if (name == "SURFACE") {
      const std::string type = inUpperCase(keyword_.value("TYPE"));
      if (!type.empty() && type != "ELEMENT" && type != "NODE") return leaveOut(keyword_);
      if (keyword_.value("NAME").empty()) return refuseHere(" needs a name, NAME=");
      const auto [entry, isNew] = surfaces_.try_emplace(partKey(keyword_.value("NAME")));
      if (!isNew) return refuseSecond(entry->second.keyword.position);
      surface_ = &entry->second;
      *surface_ = {keyword_, {}, type == "NODE"};
      reading_ = Reading::surface;
    } else if (name == "CONTACTINCLUSIONS") {
      if (!ofFirstStep()) return;
      if (!keyword_.has("ALLEXTERIOR")) return refuseHere(": ALL EXTERIOR is taken; give pairs as *CONTACT PAIR");
      general_ = contacts_.size();
      contacts_.push_back({"", "", "", keyword_.position});
    } else if (name == "CONTACTPROPERTYASSIGNMENT") {
      reading_ = Reading::interactions;
    } else if (name == "CONTACTPAIR") {
      if (ofFirstStep()) reading_ = Reading::contact;
    } else if (name == "SURFACEINTERACTION") {
      if (keyword_.value("NAME").empty()) return refuseHere(" needs a name, NAME=");
      interaction_ = inUpperCase(keyword_.value("NAME"));
      if (!frictions_.try_emplace(interaction_, 0).second)
        return refuseHere(fmt::format(" {} is given a second time; leave one out", inQuotes(interaction_)));
    } else if (name == "FRICTION") {
      if (interaction_.empty()) return refuseHere(" stands before any *SURFACE INTERACTION");
      if (const auto [first, isNew] = frictionAt_.try_emplace(interaction_, keyword_.position); !isNew)
        return refuseSecond(first->second);
      reading_ = Reading::friction;
    } else if (name == "CONTACT" || name == "SURFACEBEHAVIOR") {
      return;
    } else {
      const bool isFirst = loadsSeen_.insert(std::string(name)).second;
      if (!isFirst && forRun() && inUpperCase(keyword_.value("OP")) == "NEW")
        return refuseHere(", OP=NEW: takes away what is loaded above; leave that out instead");
      reading_ = name == "CLOAD" ? Reading::cload : name == "DLOAD" ? Reading::dload : Reading::dsload;
    }
  }
  void refuseSecond(std::size_t first) {
    const std::string name = keyword_.value("NAME");
    refuse(keyword_.position, fmt::format("*{}{} gives a second time what {} gives; leave one out", keyword_.name,
                                          name.empty() ? "" : " " + inQuotes(name), placeOf(first)));
  }
  /// Notes where a keyword stands that may be given once; false, with a refusal, for another one.
  bool firstOf(std::optional<std::size_t>& position) {
    if (position) refuseSecond(*position);
    const bool isFirst = !position;
    if (isFirst) position = keyword_.position;
    return isFirst;
  }
  void scaleMass() {
    const auto number = [&](const char* key) { return lines_.real(keyword_.value(key), key, keyword_.position); };
    const bool isFixed = withoutBlanks(keyword_.name) == "FIXEDMASSSCALING";
    if (!isFixed && !keyword_.has("DT")) return refuse(keyword_.position, "*VARIABLE MASS SCALING needs DT=");
    if (isFixed) {
      for (const DeckScaling& one : scalings_)
        if (inUpperCase(one.elset) == inUpperCase(keyword_.value("ELSET"))) return refuseSecond(one.position);
      for (const char* key : {"FACTOR", "DT"})
        if (keyword_.has(key) && !(number(key) > 0))
          refuse(keyword_.position, fmt::format("*FIXED MASS SCALING, {} must be > 0", key));
      // Without either the factor is 1, which takes that of all elements back.
      scalings_.push_back({keyword_.value("ELSET"), keyword_.has("FACTOR") ? number("FACTOR") : 1,
                           keyword_.has("DT") ? number("DT") : 0, keyword_.position});
      return;
    }
    if (!firstOf(scaledForAt_)) return;
    if (!forRun())
      return note(fmt::format("{}: *{}, DT: this is the body without the mass that a run adds",
                              lines_.where(keyword_.position), keyword_.name));
    scene_.sections["handler"] = Json{{"method", "mass-scaling"}, {"step", number("DT")}};
    scene_.origins["handler"] = lines_.where(keyword_.position);
    note(fmt::format(
        "{}: *{}, DT: mass is added where the proof of the whole body needs it; *FIXED MASS SCALING adds what "
        "each element's own step asks for, and goes with more",
        lines_.where(keyword_.position), keyword_.name));
  }
  /// *FIXED MASS SCALING, DT: point masses by the elements' own steps at rest.
  void writeScaledMass() {
    for (const DeckScaling& scaling : scalings_) {
      if (scaling.step == 0) continue;
      if (scaling.elset.empty() && !rigids_.empty())
        lines_.failAt(scaling.position,
                      "*FIXED MASS SCALING, DT beside *RIGID BODY: rigid elements need no mass; give ELSET= "
                      "of the others");
      std::set<ElementRef> own;
      for (std::size_t b = 0; b < mesh().blocks.size(); ++b)
        for (std::size_t e = 0; e < mesh().blocks[b].elementCount(); ++e)
          if (scalingOf({b, e}) == &scaling) own.insert({b, e});
      const Crossings all = scaleMasses(scaling.step, &own, "FIXED MASS SCALING, DT", scaling.position);
      note(
          fmt::format("{}: *FIXED MASS SCALING, DT: {:.6g} kg added to {} of {} elements, {:.3g} % of {:.6g} kg, whose "
                      "crossing by a wave takes less than {:.6g} s; the step is that of the bracket of the body with "
                      "this mass at their nodes",
                      lines_.where(scaling.position), all.added, all.scaled, all.count, 100 * all.added / all.mass,
                      all.mass, scaling.step));
      for (const DeckLoad& load : loads_)
        if (load.acceleration && all.scaled > 0)
          lines_.failAt(load.position,
                        fmt::format("GRAV with *FIXED MASS SCALING, DT ({}): weight is of the mass that is "
                                    "not scaled, and here of all; *VARIABLE MASS SCALING goes with it",
                                    placeOf(scaling.position)));
    }
  }
  /// What scales the mass of an element: of those of sets with it the last one, else that of all; nullptr for none.
  const DeckScaling* scalingOf(ElementRef element) {
    if (scalingOfElement_.empty() && !scalings_.empty()) {
      for (const MeshBlock& block : mesh().blocks) scalingOfElement_.emplace_back(block.elementCount(), nullptr);
      for (const DeckScaling& scaling : scalings_)
        if (scaling.elset.empty())
          for (auto& block : scalingOfElement_) block.assign(block.size(), &scaling);
      keyword_.name = "FIXED MASS SCALING";
      for (const DeckScaling& scaling : scalings_)
        if (!scaling.elset.empty())
          for (const ElementRef e : elementsOf(scaling.elset, scaling.position))
            scalingOfElement_[e.block][e.element] = &scaling;
    }
    return scalings_.empty() ? nullptr : scalingOfElement_[element.block][element.element];
  }
  /// Before all steps, or in the first.
  bool ofFirstStep() const { return steps_ < 2; }

  void data(const DeckLine& line) {
    const auto words = DeckLines::fields(line.text);
    ++dataLines_;
    if (reading_ != Reading::nothing) requireUtf8(line.text, line.position);
    switch (reading_) {
      case Reading::nothing:
        return;
      case Reading::noData:
        return refuse(line.position, fmt::format("a line of data below *{}, which has none", keyword_.name));
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
        if (words.size() % 2 != 0)
          return refuse(line.position, fmt::format("*AMPLITUDE: a line has {} numbers, a time without its value; it "
                                                   "must have pairs",
                                                   words.size()));
        for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
          amplitude_->times.push_back(lines_.real(words[i], "a time of the amplitude", line.position));
          amplitude_->values.push_back(lines_.real(words[i + 1], "a value of the amplitude", line.position));
        }
        return;
      case Reading::initial:
        return initial(words, line.position);
      case Reading::dynamic:
        if (dataLines_ > 1) return refuse(line.position, "*DYNAMIC has a second line; it has one");
        if (constexpr std::size_t times = 4; hasAtMost(times, words, line.position))
          for (std::size_t i = 0; i < words.size(); ++i) {
            times_.push_back(words[i].empty() ? 0 : lines_.real(words[i], "a time of *DYNAMIC", line.position));
            if (times_.back() < 0) refuse(line.position, "*DYNAMIC: a time is below 0");
          }
        return;
      case Reading::cload:
        return cload(words, line.position);
      case Reading::dload:
        return dload(words, line.position);
      case Reading::dsload:
        return dsload(words, line.position);
      case Reading::structure:
        if (!continued_) ++structures_.back().count;
        continued_ = line.text.back() == ',';
        return;
      case Reading::nodeSet:
        return nodeSet(words);
      case Reading::ownNode:
        ownNodes_.insert(lines_.number(words[0], "the number of a node", line.position));
        return;
      case Reading::solidSection:
        // Of solids it says nothing: a thickness is of flat elements.
        if (dataLines_ > 1) refuse(line.position, "*SOLID SECTION has a second line; it has one");
        for (const std::string_view word : words)
          if (!word.empty()) lines_.real(word, "a number of *SOLID SECTION", line.position);
        return;
      case Reading::link:
        if (words.size() != linkType_->nodes + 1)
          lines_.failAt(line.position,
                        fmt::format("{} has {} entries; it must have a number and {} node{}", linkType_->type,
                                    words.size(), linkType_->nodes, linkType_->nodes == 1 ? "" : "s"));
        links_[partKey(keyword_.value("ELSET"))].push_back(
            {linkType_, part_, {words.begin() + 1, words.end()}, line.position});
        return;
      case Reading::property:
        for (const std::string_view word : words)
          if (!word.empty()) properties_.back().numbers.emplace_back(word);
        return;
      case Reading::bulkViscosity:
        return bulkViscosity(words, line.position);
      case Reading::sectionControls:
        return sectionControls(words, line.position);
      case Reading::surface:
        if (surface_->ofNodes || words.size() < 2 || words[1].empty())
          surface_->lines.push_back({std::string(words[0]), 0, line.position});
        else if (const auto face = faceOf(words[1], 'S'))
          surface_->lines.push_back({std::string(words[0]), *face, line.position});
        else
          refuse(line.position, fmt::format("*SURFACE: {} is no face of a solid; S1 to S6 are", inQuotes(words[1])));
        return;
      case Reading::interactions:
        if (words.size() < 3 || !words[0].empty() || !words[1].empty())
          return refuse(line.position, fmt::format("*{}: its interaction is of all surfaces here, \", , NAME\"; give "
                                                   "pairs as *CONTACT PAIR",
                                                   keyword_.name));
        if (dataLines_ > 1)
          return refuse(line.position,
                        fmt::format("*{}: a second line of all surfaces; they have one interaction", keyword_.name));
        generalInteraction_ = inUpperCase(words[2]);
        return;
      case Reading::contact:
        contacts_.push_back({inUpperCase(words[0]), inUpperCase(words.size() > 1 ? words[1] : words[0]),
                             inUpperCase(keyword_.value("INTERACTION")), line.position});
        return;
      case Reading::friction:
        if (dataLines_ > 1 || words.size() > 1)
          return refuse(line.position,
                        "*FRICTION has more than one number; there is one coefficient, for all speeds, "
                        "pressures and temperatures");
        frictions_[interaction_] = lines_.real(words[0], "the coefficient of friction", line.position);
        return;
    }
  }
  /// Refuses a line with entries behind those that are known, which would be passed over.
  bool hasAtMost(std::size_t count, const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() > count)
      refuse(position,
             fmt::format("*{}: a line has {} entries; it must have at most {}", keyword_.name, words.size(), count));
    return words.size() <= count;
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
  void bulkViscosity(const std::vector<std::string_view>& words, std::size_t position) {
    if (dataLines_ > 1) return refuse(position, "*BULK VISCOSITY has a second line; it has one");
    Json& damping = scene_.sections["damping"];
    static constexpr std::string_view keys[] = {"linear_bulk_viscosity", "quadratic_bulk_viscosity"};
    if (!hasAtMost(std::size(keys), words, position)) return;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (!words[i].empty())
        damping[std::string(keys[i])] = lines_.real(words[i], "a number of *BULK VISCOSITY", position);
  }
  /// Factors of stiffness for displacements, rotations and warping, then of the two bulk viscosities.
  void sectionControls(const std::vector<std::string_view>& words, std::size_t position) {
    static constexpr std::size_t ofViscosity = 3;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (const double factor = words[i].empty() ? 1 : lines_.real(words[i], "a factor of *SECTION CONTROLS", position);
          factor != 1 && i >= ofViscosity)
        refuse(position, fmt::format("*SECTION CONTROLS: factor {} of bulk viscosity, which is of the whole body here; "
                                     "give its numbers by *BULK VISCOSITY",
                                     words[i]));
      else if (factor != 1)
        note(fmt::format("{}: *SECTION CONTROLS: factor {}: {}", lines_.where(position), words[i], hourglassHere));
  }
  void hyperelastic(const std::vector<std::string_view>& words, std::size_t position) {
    if (!onlyOneLine(position)) return;
    DeckMaterial& material = materials_.back();
    const DeckRubber& form = *material.form;
    const std::size_t count = form.constants.size();
    if (words.size() < count + 1)
      return refuse(keyword_.position, fmt::format("*HYPERELASTIC has {} numbers; it must have {}, the last of which "
                                                   "is D1",
                                                   words.size(), count + 1));
    const auto number = [&](std::size_t i) { return lines_.real(words[i], "a number of *HYPERELASTIC", position); };
    material.rubber = Json{{"model", form.model}};
    for (std::size_t i = 0; i < count; ++i) material.rubber[std::string(form.constants[i])] = number(i);
    const double d1 = number(count);
    if (!(d1 > 0)) refuse(keyword_.position, "*HYPERELASTIC: D1 must be > 0; an incompressible body has no step");
    material.rubber["bulk"] = 2 / d1;
    for (std::size_t i = 1; i < form.volumes && count + i < words.size(); ++i)
      if (!words[count + i].empty() && number(count + i) != 0)
        refuse(keyword_.position,
               fmt::format("*HYPERELASTIC: D{} = {}: the law {} has D1 alone", i + 1, words[count + i], form.model));
  }

  /// A set by its name as the mesh has it, or "#12" for a node.
  std::string selectionOf(std::string_view word, std::size_t position) {
    if (word.empty()) lines_.failAt(position, "a node or set is missing");
    if (const auto known = nodeSets_.find(inUpperCase(word)); known != nodeSets_.end()) return known->second;
    if (part_.empty() && isNumber(word) && ownNodes_.contains(lines_.number(word, "the number of a node", position)))
      return fmt::format("{}{}", ofAssembly, word);
    const std::string name = nameIn(&Mesh::nodeSets, word, position);
    return isNumber(name) ? fmt::format("#{}", lines_.number(name, "the number of a node", position)) : name;
  }
  /// The name that a set of the mesh has, or a number, in a deck of one instance without its prefix.
  template <class Sets>
  std::string nameIn(Sets Mesh::*sets, std::string_view word, std::size_t position) {
    const auto known = [&](std::string_view name) {
      if (isNumber(name)) return std::string();
      const auto set = setNamed(mesh().*sets, name);
      return set == (mesh().*sets).end() ? std::string() : set->first;
    };
    if (const std::string own = known(word); !own.empty()) return own;
    const std::string inner = inInstance(word, position), own = known(inner);
    return own.empty() ? inner : own;
  }
  /// Throws where a line is for a node that the mesh does not have, since no solid element has it.
  void requireOfMesh(const std::string& selection, const std::string& point, const std::string& what,
                     std::size_t position) {
    const bool ofRigid = !point.empty() && std::ranges::any_of(rigids_, [&](const DeckRigid& rigid) {
      return point == rigid.point || point == rigid.turning;
    });
    const bool isKnown = selection.starts_with(ofAssembly) || nodeSets_.contains(inUpperCase(selection)) ||
                         mesh().nodeSets.contains(selection);
    if (!nodesOf(selection).empty() || !(ofRigid || isKnown)) return;
    lines_.failAt(
        position,
        fmt::format("{}: {} {}", what, selection.starts_with(ofAssembly) ? selection : inQuotes(selection),
                    ofRigid ? "is the reference node of a *RIGID BODY and of no solid element; it can be held "
                              "and moved by *BOUNDARY, and the rest is for nodes of the body"
                            : "is of no solid element of the mesh; name nodes that have one by their set"));
  }
  static bool isNumber(std::string_view word) {
    return !word.empty() && std::isdigit(static_cast<unsigned char>(word.front()));
  }
  /// What is left of "INSTANCE.SET" or "INSTANCE.12" in a deck of one instance, whose sets and numbers are those of its
  /// part; else the word, or the number that the mesh has. Several instances have the same numbers.
  std::string inInstance(std::string_view word, std::size_t position) {
    std::string_view rest = word;
    std::string of;
    for (const auto& entry : instances_)
      if (inUpperCase(word).starts_with(inUpperCase(entry.first) + ".")) {
        of = inUpperCase(entry.first);
        rest = word.substr(of.size() + 1);
      }
    if (instances_.size() == 1) return std::string(rest);
    if (!isNumber(rest) || instances_.empty()) return std::string(word);
    if (of.empty())
      lines_.failAt(position, fmt::format("{}: a number in a deck of several instances; give a set, or {}.{}",
                                          inQuotes(word), instances_.begin()->first, word));
    if (!offsets_) offsets_ = detail::instanceOffsets(file_, text_);
    return fmt::format("{}", offsets_->at(of) + lines_.number(rest, "a number", position));
  }
  /// Sets are named in any case.
  template <class Sets>
  static typename Sets::const_iterator setNamed(const Sets& sets, std::string_view name) {
    return std::ranges::find_if(sets, [&](const auto& set) { return inUpperCase(set.first) == inUpperCase(name); });
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

  /// Nodes of sets of one node have a name beside their number, which tells nodes of parts apart.
  void nodeSet(const std::vector<std::string_view>& words) {
    const std::string instance = inUpperCase(keyword_.value("INSTANCE"));
    for (const std::string_view word : words) {
      if (word.empty()) continue;
      const std::string one =
          isNumber(word) && !instance.empty() ? fmt::format("{}/{}", instance, word) : pointOf(word);
      std::string& point = points_[partKey(keyword_.value("NSET"))];
      point = point.empty() && !one.empty() ? one : severalNodes;
    }
  }
  /// What stands for a node: its instance, or part in one, and number, of a number or of a set of one node; "" for
  /// several.
  std::string pointOf(std::string_view word) const {
    if (isNumber(word)) return fmt::format("{}/{}", part_, word);
    const std::string name = inUpperCase(word);
    const auto find = [&](const std::string& key) {
      const auto found = points_.find(key);
      return found == points_.end() || found->second == severalNodes ? std::string() : found->second;
    };
    if (std::string own = find(name); !own.empty()) return own;
    for (const auto& [instance, part] : instances_)
      if (const std::string prefix = inUpperCase(instance) + "."; name.starts_with(prefix)) {
        const std::string rest = name.substr(prefix.size());
        const std::string inner = isNumber(rest) ? "/" + rest : find(part + "/" + rest);
        return inner.empty() ? inner : inUpperCase(instance) + inner.substr(inner.rfind('/'));
      }
    return {};
  }

  void boundary(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 2) lines_.failAt(position, "*BOUNDARY needs a node or set and a degree of freedom");
    if (constexpr std::size_t entries = 4; !hasAtMost(entries, words, position)) return;
    DeckBoundary held;
    held.selection = selectionOf(words[0], position);
    held.position = position;
    held.point = pointOf(words[0]);
    struct Named {
      std::string_view name, components, turns;
    };
    static constexpr Named named[] = {{"ENCASTRE", "xyz", "xyz"}, {"PINNED", "xyz", ""}, {"XSYMM", "x", "yz"},
                                      {"YSYMM", "y", "xz"},       {"ZSYMM", "z", "xy"},  {"XASYMM", "yz", "x"},
                                      {"YASYMM", "xz", "y"},      {"ZASYMM", "xy", "z"}};
    const std::string word = inUpperCase(words[1]);
    if (const auto* known = std::ranges::find(named, word, &Named::name); known != std::end(named)) {
      held.components = known->components;
      held.turns = known->turns;
      boundaries_.push_back(held);
      return;
    }
    const std::int64_t first = lines_.number(words[1], "the first degree of freedom", position);
    const std::int64_t last =
        words.size() > 2 && !words[2].empty() ? lines_.number(words[2], "the last degree of freedom", position) : first;
    constexpr std::int64_t temperature = 11;
    if (first == temperature && last == temperature) {
      if (noted_.insert(fmt::format("temperature {}", keyword_.position)).second) follow(DeckRule::temperature, "", {});
      return;
    }
    if (last > 6 || first > last)
      return refuse(position, fmt::format("*BOUNDARY: degrees of freedom {} to {}; a solid has 1 to 3", first, last));
    for (std::int64_t dof = first; dof <= std::min<std::int64_t>(last, 3); ++dof)
      held.components += static_cast<char>('x' + (dof - 1));
    for (std::int64_t dof = std::max<std::int64_t>(first, 4); dof <= last; ++dof)
      held.turns += static_cast<char>('x' + (dof - 4));
    if (words.size() > 3 && !words[3].empty()) held.value = lines_.real(words[3], "the value", position);
    if (held.value != 0 && !inStep_)
      return refuse(position, "*BOUNDARY before the step holds nodes where they are; a value belongs in the step");
    held.velocity = inUpperCase(keyword_.value("TYPE")) == "VELOCITY";
    held.amplitude = inUpperCase(keyword_.value("AMPLITUDE"));
    boundaries_.push_back(held);
  }

  void initial(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 3) lines_.failAt(position, "an initial velocity needs a node or set, 1, 2 or 3, and its value");
    const std::optional<int> component = componentOf(words[1], position);
    const double velocity = lines_.real(words[2], "the velocity", position);
    if (constexpr std::size_t entries = 3; !hasAtMost(entries, words, position)) return;
    if (!component) {
      if (velocity != 0)
        refuse(position,
               "*INITIAL CONDITIONS: a velocity of rotation; a solid's nodes do not turn, and [[initial]] "
               "with angular_velocity of a scene turns a body");
      return;
    }
    initials_.push_back({selectionOf(words[0], position), pointOf(words[0]), *component, velocity, position});
  }

  void cload(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 3) lines_.failAt(position, "*CLOAD needs a node or set, 1, 2 or 3, and a force");
    if (constexpr std::size_t entries = 3; !hasAtMost(entries, words, position)) return;
    const std::optional<int> component = componentOf(words[1], position);
    if (!component) return refuse(position, "*CLOAD: a moment; a solid's nodes have forces");
    DeckLoad load{selectionOf(words[0], position), Eigen::Vector3d::Zero()};
    load.value[*component] = lines_.real(words[2], "the force", position);
    load.point = pointOf(words[0]);
    load.amplitude = inUpperCase(keyword_.value("AMPLITUDE"));
    load.position = position;
    loads_.push_back(load);
  }

  void dload(const std::vector<std::string_view>& words, std::size_t position) {
    const std::string label = words.size() > 1 ? inUpperCase(words[1]) : "";
    if (const std::optional<int> face = faceOf(label, 'P')) {
      if (words.size() < 3) lines_.failAt(position, "*DLOAD needs an element or set, a face, P1 to P6, and a pressure");
      if (constexpr std::size_t entries = 3; !hasAtMost(entries, words, position)) return;
      return press(facesOf(std::string(words[0]), *face, position), words[2], position);
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
    if (constexpr std::size_t entries = 6; !hasAtMost(entries, words, position)) return;
    const Eigen::Vector3d direction(lines_.real(words[3], "the direction", position),
                                    lines_.real(words[4], "the direction", position),
                                    lines_.real(words[5], "the direction", position));
    if (!words[0].empty()) elementsOf(words[0], position);
    if (direction.isZero(0)) lines_.failAt(position, "GRAV: the direction is zero");
    loads_.push_back({"",
                      lines_.real(words[2], "the acceleration", position) * direction.normalized(),
                      true,
                      {},
                      std::string(words[0]),
                      inUpperCase(keyword_.value("AMPLITUDE")),
                      position});
  }
  /// The number of "P3" or "S3"; empty for another word.
  static std::optional<int> faceOf(std::string_view word, char letter) {
    if (word.size() != 2 || std::toupper(static_cast<unsigned char>(word[0])) != letter || word[1] < '1' ||
        word[1] > '6')
      return std::nullopt;
    return word[1] - '0';
  }
  /// The elements of a set, or the one with that number.
  std::vector<ElementRef> elementsOf(std::string_view word, std::size_t position) {
    const std::string given = nameIn(&Mesh::elementSets, word, position);
    if (isNumber(given)) {
      const std::int64_t number = lines_.number(given, "the element", position);
      if (const auto element = numbers().element(number)) return {*element};
      lines_.failAt(position, fmt::format("*{}: the mesh has no element {}", keyword_.name, number));
    }
    if (const auto set = mesh().elementSets.find(given); set != mesh().elementSets.end()) return set->second;
    lines_.failAt(position, fmt::format("*{}: there is no element set {}", keyword_.name, inQuotes(word)));
  }
  /// The faces of the surface of the mesh with a number, of elements, or all of these that lie outside for 0.
  std::vector<std::int32_t> facesOf(const std::string& elements, int face, std::size_t position) {
    std::vector<std::int32_t> result;
    for (const ElementRef element : elementsOf(elements, position)) {
      if (face == 0) {
        constexpr int mostFaces = 6;
        for (int number = 1; number <= mostFaces; ++number)
          if (const auto found = faces().find(element, number); found && *found >= 0) result.push_back(*found);
        continue;
      }
      const MeshBlock& block = mesh().blocks[element.block];
      const auto named = [&] {
        return fmt::format("*{}: face {} of {} element {}", keyword_.name, face, elementInfo(block.type).name,
                           block.id(static_cast<std::size_t>(element.element)));
      };
      const std::optional<std::int32_t> found = faces().find(element, face);
      if (!found)
        refuse(position, named() + ": there is no such face");
      else if (*found < 0)
        refuse(position, named() + " lies inside the mesh");
      else
        result.push_back(*found);
      if (!found || *found < 0) break;
    }
    return result;
  }
  void press(const std::vector<std::int32_t>& faces, std::string_view value, std::size_t position) {
    DeckWriter::press(faces, lines_.real(value, "the pressure", position), inUpperCase(keyword_.value("AMPLITUDE")),
                      keyword_.position);
  }
  void dsload(const std::vector<std::string_view>& words, std::size_t position) {
    if (words.size() < 3 || inUpperCase(words[1]) != "P")
      return refuse(position, "*DSLOAD: a line must be a surface, P, and a pressure; no other load is taken");
    if (constexpr std::size_t entries = 3; !hasAtMost(entries, words, position)) return;
    const auto& [surface, prefix] = surfaceNamed(words[0]);
    if (surface == nullptr || surface->ofNodes)
      return refuse(position, fmt::format("*DSLOAD: there is no *SURFACE {} of element faces", inQuotes(words[0])));
    press(facesOf(*surface, prefix, position), words[2], position);
  }
  /// The faces of a surface, each once. prefix: of its names, that of the instance.
  std::vector<std::int32_t> facesOf(const Surface& surface, const std::string& prefix, std::size_t position) {
    std::set<std::int32_t> faces;
    for (const DeckSurfaceLine& line : surface.lines)
      for (const std::int32_t face : facesOf(prefix + line.elements, line.face, position)) faces.insert(face);
    return {faces.begin(), faces.end()};
  }
  /// A surface, as used from now on, with what is to be put before the names in it; nullptr for none. One of a part is
  /// INSTANCE.NAME, and NAME alone where there is one instance.
  std::pair<Surface*, std::string> surfaceNamed(std::string_view word) {
    const auto find = [&](const std::string& key) {
      const auto found = surfaces_.find(key);
      if (found != surfaces_.end()) found->second.used = true;
      return found == surfaces_.end() ? nullptr : &found->second;
    };
    const std::string name = inUpperCase(word);
    if (Surface* own = find(name)) return {own, ""};
    for (const auto& [instance, part] : instances_) {
      const std::string prefix = inUpperCase(instance) + ".";
      const bool named = name.starts_with(prefix);
      if (!named && instances_.size() > 1) continue;
      if (Surface* own = find(part + "/" + (named ? name.substr(prefix.size()) : name))) return {own, prefix};
    }
    return {nullptr, ""};
  }
  /// Names of an element set of a part as the mesh has them: one for each instance.
  std::vector<std::string> elementSetsOf(const DeckSection& section) const {
    const std::string key = inUpperCase(section.elset);
    const auto known = elementSets_.find(section.part.empty() ? key : section.part + "/" + key);
    const std::string name = known == elementSets_.end() ? section.elset : known->second;
    if (section.part.empty()) return {name};
    std::vector<std::string> names;
    for (const auto& [instance, part] : instances_)
      if (part == section.part && (section.instance.empty() || section.instance == instance))
        names.push_back(instances_.size() > 1 || elementSets_.count(key) != 0 ? instance + "." + name : name);
    return names;
  }

  void writeMaterials() {
    if (sections_.empty()) {
      (void)mesh();  // which may have no solids
      throw InputError(
          fmt::format("{}: no *SOLID SECTION gives the elements a material{}", file_.string(),
                      forRun() ? "" : "; give a law to take the mesh alone: --young, --poisson, --density"));
    }
    Json list = Json::array();
    std::vector<std::string> origins;
    const auto materialOf = [&](const DeckSection& section) -> const DeckMaterial& {
      const auto material = std::ranges::find(materials_, section.material,
                                              [](const DeckMaterial& one) { return inUpperCase(one.name); });
      if (material == materials_.end())
        lines_.failAt(section.position,
                      fmt::format("*SOLID SECTION: there is no *MATERIAL {}", inQuotes(section.material)));
      if (!material->elastic && material->rubber.is_null())
        lines_.failAt(material->position,
                      fmt::format("*MATERIAL {} has no *ELASTIC and no *HYPERELASTIC", inQuotes(material->name)));
      return *material;
    };
    // A card of a material that is not the only one is read in two ways.
    if (instances_.empty())
      for (const DeckSection& section : sections_)
        for (const DeckMaterial& one : materials_)
          if (one.damping && !materialOf(section).damping)
            lines_.failAt(*one.dampingAt,
                          fmt::format("*DAMPING of one of several materials: CalculiX damps the whole body by it, and "
                                      "Abaqus {} alone; give {} its own, *DAMPING, ALPHA=0 for none",
                                      inQuotes(one.name), inQuotes(section.material)));
    // What all materials damp alike is of the body, which goes with more of the program, but of nothing else.
    const DeckMaterial& first = materialOf(sections_.front());
    const bool alike =
        properties_.empty() && contacts_.empty() &&
        std::ranges::all_of(sections_, [&](const DeckSection& s) { return materialOf(s).damping == first.damping; });
    if (alike && first.damping) {
      scene_.sections["damping"]["mass"] = first.damping->first;
      scene_.sections["damping"]["stiffness"] = first.damping->second;
      for (const char* key : {"damping.mass", "damping.stiffness"})
        scene_.origins[key] = lines_.where(*first.dampingAt);
    }
    for (const DeckSection& section : sections_) {
      const DeckMaterial& material = materialOf(section);
      for (const std::string& set : elementSetsOf(section)) {
        Json entry = material.elastic ? Json{{"model", nonlinear_ ? "stvk" : "linear"},
                                             {"young", material.elastic->first},
                                             {"poisson", material.elastic->second}}
                                      : material.rubber;
        if (!alike && material.damping) {
          entry["mass_damping"] = material.damping->first;
          if (material.damping->second != 0) entry["stiffness_damping"] = material.damping->second;
        }
        for (const auto& [part, rules] : setsByRules(set)) {
          entry["rules"] = Json::array();
          for (const auto& [element, rule] : rules) entry["rules"].push_back(element + "=" + rule);
          for (Scaled& scaled : scaledParts(part)) {
            entry["set"] = scaled.set;
            if (material.density) entry["density"] = *material.density * scaled.factor;
            if (material.density && !scaled.elements.empty())
              addWaves(entry, std::move(scaled.elements), "*MATERIAL", material.position);
            list.push_back(entry);
            origins.push_back(lines_.where(material.position));
          }
        }
      }
    }
    if (list.empty())
      lines_.failAt(sections_.front().position, "*SOLID SECTION: there is no *INSTANCE of the part that it is in");
    writeMaterialList(std::move(list), origins);
  }
  /// Sets that a set of elements is of, each with one rule for an element.
  std::map<std::string, ElementRules> setsByRules(const std::string& set) {
    std::map<std::string, ElementRules> found;
    const std::string prefix = set + std::string(detail::setOfType);
    if (byType_)
      for (const auto& [name, elements] : mesh().elementSets)
        if (const DeckSolid* solid = name.starts_with(prefix) ? findDeckSolid(name.substr(prefix.size())) : nullptr)
          found[name].emplace(solid->element, solid->rule);
    if (found.empty()) found[set] = rules_;
    return found;
  }

  /// The elements of a section, by its set in the mesh, with their numbers where not all are alike, by the factor of
  /// their mass. A set that the mesh does not have is as it stands.
  struct Scaled {
    std::string set;
    double factor;
    std::vector<ElementRef> elements;
  };
  std::vector<Scaled> scaledParts(const std::string& set) {
    const auto known = mesh().elementSets.find(set);
    if (scalings_.empty() || known == mesh().elementSets.end()) return {{set, 1, {}}};
    std::map<double, std::vector<ElementRef>> byFactor;
    for (const ElementRef element : known->second) {
      const DeckScaling* scaling = scalingOf(element);
      byFactor[scaling ? scaling->factor : 1].push_back(element);
    }
    std::vector<Scaled> parts;
    for (auto& [factor, elements] : byFactor) {
      std::vector<std::int64_t> numbers;
      for (const ElementRef e : elements)
        if (byFactor.size() > 1) numbers.push_back(mesh().blocks[e.block].id(static_cast<std::size_t>(e.element)));
      parts.push_back(
          {numbers.empty() ? set : fmt::format("#{}", fmt::join(numbers, ",")), factor, std::move(elements)});
    }
    return parts;
  }

  static bool isOn(const DeckKeyword& keyword, const std::string& parameter) {
    return keyword.has(parameter) && inUpperCase(keyword.value(parameter)) != "NO";
  }

  bool fixesStep() const { return isOn(*dynamic_, "DIRECT") || dynamic_->has("DIRECTUSERCONTROL"); }

  void writeIntegrator() {
    Json& integrator = scene_.sections["integrator"] = Json{{"step", "auto"}, {"end", 1.0}};
    scene_.origins["integrator"] = file_.string();
    const bool isExplicit = dynamic_ && dynamic_->has("EXPLICIT"), fixed = dynamic_ && fixesStep();
    const std::string where = dynamic_ ? lines_.where(dynamic_->position) : file_.string();
    if (isExplicit && times_.size() > 2 && times_[2] > 0)
      note(
          fmt::format("{}: *DYNAMIC, least increment {} s: CalculiX adds mass where an element needs a smaller step; "
                      "none is added here; handler.method = \"mass-scaling\" with handler.step = {} adds it",
                      where, times_[2], times_[2]));
    if (isExplicit && !viscosityAt_)
      note(
          fmt::format("{}: *DYNAMIC, EXPLICIT without *BULK VISCOSITY: there is none here, as in CalculiX; "
                      "Abaqus/Explicit has 0.06 and 1.2 unasked, which *BULK VISCOSITY says here",
                      where));
    const auto requirePositive = [&](double value, std::string_view what, std::string_view instead) {
      if (!(value > 0))
        throw InputError(fmt::format("{}: *DYNAMIC: its {} is {}; it must be above 0{}", where, what, value, instead));
    };
    if ((isExplicit || forRun()) && times_.size() > 1) {
      if (fixed)
        requirePositive(times_[0], "step", " s, which DIRECT holds; without DIRECT the step follows the safe one");
      requirePositive(times_[1], "length", " s");
    }
    if (!forRun()) {
      // The step that the deck asks for is one to hold against the bracket.
      if (isExplicit && fixed && times_.size() > 1) integrator = Json{{"step", times_[0]}, {"end", times_[1]}};
      return;
    }
    if (!dynamic_)
      throw InputError(
          fmt::format("{}: has no *DYNAMIC step, and so no motion to run; ringwatch inspect tells the "
                      "step that its body can take",
                      file_.string()));
    scene_.origins["integrator"] = where;
    if (times_.size() < 2)
      throw InputError(fmt::format("{}: *DYNAMIC needs a line with its step and its length, s", where));
    integrator["end"] = times_[1];
    const bool held = !fixed && isOn(*dynamic_, "FIXEDTIMEINCREMENTATION");
    if (fixed) integrator["step"] = times_[0];
    if (held) integrator["hold"] = true;
    if (dynamic_->has("SCALEFACTOR"))
      integrator["safety"] = lines_.real(dynamic_->value("SCALEFACTOR"), "SCALE FACTOR", dynamic_->position);
    if (!isExplicit || !fixed)
      note(fmt::format("{}: *DYNAMIC {}: {}", where,
                       isExplicit ? "leaves the step to the program" : "is implicit there, and is run explicitly here",
                       fixed ? "its step is held; integrator.step = \"auto\" follows the safe step"
                       : held
                           ? "the step that is safe at the start is held; integrator.hold = false follows the safe step"
                           : "the step follows the safe step"));
    for (const auto& [entry, name] : {std::pair<std::size_t, const char*>{0, "first"}, {3, "largest"}})
      if (!fixed && times_.size() > entry && times_[entry] > 0)
        note(
            fmt::format("{}: *DYNAMIC, {} increment {} s: it does not bound the step, which is as large as is "
                        "proven; integrator.step fixes it",
                        where, name, times_[entry]));
    note(fmt::format("{}: *STEP {}: linear elasticity is {}{}", lines_.where(step_.position),
                     nonlinear_ ? "with NLGEOM" : "without NLGEOM", nonlinear_ ? "stvk" : "linear",
                     isExplicit && !step_.has("NLGEOM") ? ", as in CalculiX; Abaqus/Explicit has large displacements "
                                                          "unasked, which NLGEOM says here"
                                                        : ""));
  }

  const DeckAmplitude& amplitudeOf(const std::string& name, std::size_t position) const {
    const auto found = amplitudes_.find(name);
    if (found == amplitudes_.end()) lines_.failAt(position, fmt::format("there is no *AMPLITUDE {}", inQuotes(name)));
    if (found->second.times.empty()) lines_.failAt(found->second.position, "*AMPLITUDE has no points");
    return found->second;
  }
  bool rampsLoads() const { return inUpperCase(step_.value("AMPLITUDE")) == "RAMP"; }

  Table tableOf(const std::string& amplitude, std::size_t position) const override {
    if (amplitude.empty()) {
      if (!rampsLoads()) return {};  // at once, as in every *DYNAMIC step
      return {Json{{"times", {0.0, times_[1]}}, {"factors", {0.0, 1.0}}}};
    }
    const DeckAmplitude& points = amplitudeOf(amplitude, position);
    if (points.times.size() == 1) return {Json::object(), points.values[0]};
    Table table{Json{{"times", points.times}, {"factors", points.values}}};
    if (points.smooth) table.entries["ramp"] = "quintic";
    return table;
  }
  Table displacementTable(const DeckBoundary& held) const override {
    if (held.amplitude.empty() && !rampsLoads())
      lines_.failAt(held.position, "*BOUNDARY: the nodes would jump to their place at once; give an AMPLITUDE from 0");
    Table table = tableOf(held.amplitude, held.position);
    if (table.entries.empty() || table.entries["factors"][0] != 0)
      lines_.failAt(amplitudeOf(held.amplitude, held.position).position,
                    "*AMPLITUDE of a displacement must have two points or more, the first of value 0, or the nodes "
                    "would jump to their place at once");
    return table;
  }

  void addNodesOf(ElementRef e, std::set<std::int64_t>& ids) {
    const MeshBlock& block = mesh().blocks[e.block];
    for (int a = 0; a < block.nodesPerElement(); ++a) ids.insert(mesh().nodeId(block.element(e.element)[a]));
  }
  /// The nodes of a rigid body, "#3,7".
  std::string nodesOfRigid(const DeckKeyword& keyword) {
    std::set<std::int64_t> ids;
    if (const std::string elements = keyword.value("ELSET"); !elements.empty())
      for (const ElementRef e : elementsOf(elements, keyword.position)) addNodesOf(e, ids);
    for (const char* key : {"NSET", "TIENSET", "PINNSET"})
      if (const std::string set = keyword.value(key); !set.empty())
        for (const std::int32_t node : nodesOf(selectionOf(set, keyword.position))) ids.insert(mesh().nodeId(node));
    if (ids.empty()) lines_.failAt(keyword.position, "*RIGID BODY has no nodes; ELSET=, NSET= and TIE NSET= give them");
    return fmt::format("#{}", fmt::join(ids, ","));
  }
  /// A body that does not turn moves alike at all of its points, and one that nothing holds moves by its forces: for
  /// these it does not matter where the reference node is.
  void writeRigids() {
    for (const DeckRigid& rigid : rigids_) {
      keyword_ = rigid.keyword;
      const std::size_t position = rigid.keyword.position;
      const auto refuseRigid = [&](const std::string& what) { lines_.failAt(position, "*RIGID BODY: " + what); };
      const std::string name = fmt::format("rigid body {}", scene_.sections["rigid"].size());
      keepApart("rigid");
      addEntry("rigid", nodesOfRigid(rigid.keyword), {{"name", name}}, position);
      std::set<char> held, turns;
      std::vector<DeckBoundary> moving;
      for (const DeckBoundary& one : boundaries_) {
        // Of a node of its own for the rotations they are its first three degrees of freedom.
        const std::string& turned = rigid.turning == rigid.point ? one.turns : one.components;
        if (one.point == rigid.turning) turns.insert(turned.begin(), turned.end());
        if (forRun() && one.point == rigid.turning && one.value != 0 && !turned.empty())
          refuseRigid("its reference node is turned; angular_velocity of a scene's [[move]] does that");
        if (one.point != rigid.point) continue;
        held.insert(one.components.begin(), one.components.end());
        if (one.value != 0) moving.push_back(one);
      }
      std::erase_if(boundaries_,
                    [&](const DeckBoundary& one) { return one.point == rigid.point || one.point == rigid.turning; });
      if (held.empty() && turns.empty()) continue;
      constexpr std::size_t all = 3;
      if (turns.size() != all || held.empty())
        refuseRigid(
            "its reference node must have all of its rotations held, or be free altogether; a scene's [[fix]] with "
            "rigid, turns, axis and point holds it otherwise");
      Json entry{{"rigid", name}, {"components", std::string(held.begin(), held.end())}};
      writeGuide(entry, moving, position);
    }
  }
  void writeGuide(Json entry, const std::vector<DeckBoundary>& moving, std::size_t position) {
    std::string section = "fix";
    if (!moving.empty() && forRun()) {
      section = "move";
      const DeckBoundary& first = moving.front();
      Eigen::Vector3d value = Eigen::Vector3d::Zero();
      for (const DeckBoundary& one : moving) {
        if (one.amplitude != first.amplitude || one.velocity != first.velocity)
          lines_.failAt(one.position, "*BOUNDARY: the reference node of a *RIGID BODY moves by one amplitude");
        for (const char c : one.components) value[c - 'x'] = one.value;
      }
      const Table table = first.velocity ? tableOf(first.amplitude, first.position) : displacementTable(first);
      entry[first.velocity ? "velocity" : "displacement"] = listOf(table.factor * value);
      entry.update(table.entries);
    }
    Json& list = scene_.sections[section];
    if (list.is_null()) list = Json::array();
    scene_.origins[fmt::format("{}.{}", section, list.size())] = lines_.where(position);
    list.push_back(std::move(entry));
  }

  void writeInitials() {
    // Entries of a scene add up; of a deck the last value of a node counts.
    std::map<std::pair<std::int32_t, int>, double> given;
    for (const DeckInitial& start : initials_) {
      requireOfMesh(start.selection, start.point, "*INITIAL CONDITIONS", start.position);
      std::set<double> before;
      for (const std::int32_t node : nodesOf(start.selection)) {
        double& value = given[{node, start.component}];
        before.insert(value);
        value = start.velocity;
      }
      if (before.size() > 1)
        lines_.failAt(start.position,
                      "*INITIAL CONDITIONS: its nodes have different velocities already, of lines above; give each set "
                      "of nodes its velocity once");
      Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
      velocity[start.component] = start.velocity - (before.empty() ? 0 : *before.begin());
      addEntry("initial", start.selection, {{"velocity", listOf(velocity)}}, start.position);
    }
  }
  void writeLinks() {
    if (!nonlinear_)
      for (const auto& [elset, links] : links_)
        if (!links.empty() && links.front().type->nodes == 2 && isInstanced(links.front().part))
          note(
              fmt::format("{}: the {} follows the line between its nodes; CalculiX keeps its first direction without "
                          "NLGEOM",
                          lines_.where(links.front().position), links.front().type->type));
    for (const DeckProperty& property : properties_) {
      if (!isInstanced(property.part)) continue;
      const std::string key = inUpperCase(property.elset);
      const auto own = links_.find(property.part.empty() ? key : property.part + "/" + key);
      const auto of = [&](const DeckLink& link) { return link.type->keyword == property.keyword; };
      if (own == links_.end() || own->second.empty() || !std::ranges::all_of(own->second, of))
        lines_.failAt(property.position,
                      fmt::format("*{}: {} is the ELSET of no such elements above; {} are taken", property.keyword,
                                  inQuotes(property.elset), linkTypesOf(property.keyword)));
      if (!property.part.empty() && instances_.size() > 1)
        lines_.failAt(property.position, fmt::format("*{}: in a part, with several instances; write its elements in "
                                                     "the assembly, with sets INSTANCE.SET of one node as their "
                                                     "nodes",
                                                     property.keyword));
      for (const DeckLink& link : own->second) writeLink(link, property);
      links_.erase(own);
    }
    for (const auto& [elset, links] : links_)
      if (!links.empty() && isInstanced(links.front().part))
        lines_.failAt(links.front().position, fmt::format("*ELEMENT, TYPE={}: no *{} names its ELSET",
                                                          links.front().type->type, links.front().type->keyword));
  }
  static std::string linkTypesOf(std::string_view keyword) {
    std::vector<std::string_view> names;
    for (const DeckLinkType& type : linkTypes)
      if (type.keyword == keyword) names.push_back(type.type);
    return listed(names);
  }
  void writeLink(const DeckLink& link, const DeckProperty& property) {
    const bool toGround = link.type->nodes == 1 && property.keyword != "MASS";
    const std::size_t wanted = toGround ? 2 : 1;
    if (property.numbers.size() != wanted)
      lines_.failAt(property.position,
                    fmt::format("*{} of {} has {} numbers; it must have {}, and none that depend on temperature or "
                                "frequency",
                                property.keyword, link.type->type, property.numbers.size(),
                                toGround ? "a degree of freedom and one more" : "one"));
    const double value = lines_.real(property.numbers.back(), "a number of *" + property.keyword, property.position);
    const auto nodeOf = [&](const std::string& word) {
      const std::string selection = selectionOf(word, link.position);
      requireOfMesh(selection, pointOf(word), fmt::format("*ELEMENT, TYPE={}", link.type->type), link.position);
      if (const std::size_t count = nodesOf(selection).size(); count != 1)
        lines_.failAt(link.position, fmt::format("{}: {} is {} nodes of the mesh; it must be one", link.type->type,
                                                 inQuotes(word), count));
      return selection;
    };
    const std::string node = nodeOf(link.nodes[0]);
    if (property.keyword == "MASS") {
      keepApart("mass");  // the mass of an entry is that of all its nodes
      return addEntry("mass", node, {{"mass", value}}, link.position);
    }
    Json entry =
        property.keyword == "SPRING" ? Json{{"stiffness", value}} : Json{{"stiffness", 0.0}, {"damping", value}};
    if (toGround) {
      const std::int64_t dof = lines_.number(property.numbers[0], "the degree of freedom", property.position);
      if (dof > 3)
        lines_.failAt(property.position, fmt::format("*{}: degree of freedom {} is none of a solid's; 1, 2 and 3 are",
                                                     property.keyword, dof));
      entry["direction"] = listOf(Eigen::Vector3d::Unit(dof - 1));
    } else {
      entry["to_set"] = nodeOf(link.nodes[1]);
    }
    addEntry("spring", node, entry, link.position);
  }
  void writeContacts() {
    if (general_ && contacts_.size() > 1)
      lines_.failAt(contacts_.back().position, "contact beside that of all surfaces, which has it already; give one");
    if (general_) contacts_[*general_].interaction = generalInteraction_;
    for (const DeckContact& contact : contacts_) {
      const auto friction = frictions_.find(contact.interaction);
      if (!contact.interaction.empty() && friction == frictions_.end())
        lines_.failAt(contact.position,
                      fmt::format("contact: there is no *SURFACE INTERACTION {}", inQuotes(contact.interaction)));
      Json entry{{"with", "surface"}};
      if (friction != frictions_.end() && friction->second != 0) entry["friction"] = friction->second;
      if (contact.nodes.empty()) {
        addContact(entry, "", "", false, contact.position);
        continue;
      }
      // The nodes of each side touch the faces of the other, if it has any.
      const auto one = contactSide(contact.nodes, contact.position),
                 other = contactSide(contact.faces, contact.position);
      if (other.second)
        lines_.failAt(contact.position, fmt::format("*CONTACT PAIR: {} has no faces; a *SURFACE of TYPE=ELEMENT has",
                                                    inQuotes(contact.faces)));
      addContact(entry, one.first, other.first, !one.second, contact.position);
    }
  }
  /// The nodes of a surface, "#3,7", and whether it has no faces.
  std::pair<std::string, bool> contactSide(const std::string& name, std::size_t position) {
    const auto& [surface, prefix] = surfaceNamed(name);
    if (surface == nullptr)
      lines_.failAt(position, fmt::format("*CONTACT PAIR: there is no *SURFACE {}", inQuotes(name)));
    if (surface->ofNodes) {
      std::set<std::int64_t> nodes;
      for (const DeckSurfaceLine& line : surface->lines) {
        const auto own = nodesOf(selectionOf(prefix + line.elements, line.position));
        if (own.empty())
          lines_.failAt(line.position,
                        fmt::format("*SURFACE: {} is no node set and no node of the mesh", inQuotes(line.elements)));
        for (const std::int32_t node : own) nodes.insert(mesh().nodeId(node));
      }
      return {fmt::format("#{}", fmt::join(nodes, ",")), true};
    }
    const std::vector<std::int32_t> outside = facesOf(*surface, prefix, position);
    throwRefused();
    const std::vector<std::string> sets = faces().nodeSetsOf(outside);
    if (sets.size() != 1)
      lines_.failAt(position, fmt::format("*CONTACT PAIR: the faces of {} are not told from others by their nodes",
                                          inQuotes(name)));
    return {sets.front(), false};
  }
  /// Makes one load of gravity of those that are equal, set by set. The force on a node is that of its whole mass, so
  /// that sets must not share nodes with elements without.
  void joinGravity() {
    std::vector<DeckLoad> joined;
    std::vector<std::set<ElementRef>> elements;
    for (const DeckLoad& load : std::exchange(loads_, {})) {
      const auto own = load.elements.empty() ? std::vector<ElementRef>() : elementsOf(load.elements, load.position);
      if (load.elements.empty() || own.size() == mesh().elementCount()) {
        loads_.push_back(load);
        continue;
      }
      std::size_t i = 0;
      const auto isApart = [&](ElementRef e) { return !elements[i].contains(e); };
      while (i < joined.size() && (joined[i].value != load.value || joined[i].amplitude != load.amplitude ||
                                   !std::ranges::all_of(own, isApart)))
        ++i;
      if (i == joined.size()) {
        joined.push_back(load);
        elements.emplace_back();
      }
      elements[i].insert(own.begin(), own.end());
    }
    for (std::size_t i = 0; i < joined.size(); ++i) {
      if (elements[i].size() != mesh().elementCount()) {
        std::set<std::int64_t> ids, others;
        for (std::size_t b = 0; b < mesh().blocks.size(); ++b)
          for (std::size_t e = 0; e < mesh().blocks[b].elementCount(); ++e)
            addNodesOf({b, e}, elements[i].contains({b, e}) ? ids : others);
        for (const std::int64_t id : ids)
          if (others.contains(id))
            lines_.failAt(joined[i].position,
                          fmt::format("*DLOAD, GRAV on {}: its node {} is also one of elements without this load; sets "
                                      "with equal GRAV must be whole bodies together",
                                      inQuotes(joined[i].elements), id));
        joined[i].selection = fmt::format("#{}", fmt::join(ids, ","));
      }
      loads_.push_back(joined[i]);
    }
  }
  void writeLoads() {
    joinGravity();
    for (const DeckLoad& load : loads_) {
      const auto byFactor = std::ranges::find_if(scalings_, [](const DeckScaling& one) { return one.factor != 1; });
      if (load.acceleration && byFactor != scalings_.end())
        lines_.failAt(load.position, fmt::format("GRAV with *FIXED MASS SCALING, FACTOR ({}): weight is of the mass "
                                                 "that is not scaled, and here of all; give the sum as *CLOAD",
                                                 placeOf(byFactor->position)));
      const auto mass = std::ranges::find_if(
          properties_, [&](const DeckProperty& one) { return one.keyword == "MASS" && isInstanced(one.part); });
      if (!load.elements.empty() && mass != properties_.end())
        lines_.failAt(load.position, fmt::format("GRAV on {}: the masses of *MASS ({}) are not in it; leave the name "
                                                 "out for all, or give the weight of the others as *CLOAD",
                                                 inQuotes(load.elements), placeOf(mass->position)));
      if (!load.acceleration) requireOfMesh(load.selection, load.point, "*CLOAD", load.position);
      writeLoad(load);
    }
  }
  DeckKeyword keyword_;
  Reading reading_ = Reading::nothing;
  int dataLines_ = 0, steps_ = 0;
  bool inStep_ = false, nonlinear_ = false;
  bool continued_ = false;     // an element goes on in the next line
  bool ofStructures_ = false;  // a section is of elements that are no solids
  DeckKeyword step_;
  std::optional<DeckKeyword> dynamic_, temperature_, expansion_;
  std::vector<double> times_;                                   // of *DYNAMIC, s
  std::string part_;                                            // that is being read, upper case
  std::string instance_;                                        // likewise, as written
  std::vector<std::pair<std::string, std::string>> instances_;  // name, part
  std::map<std::string, std::string> nodeSets_, elementSets_;   // in upper case, PART/SET in a part -> as written
  std::optional<std::map<std::string, std::int64_t>> offsets_;  // of the numbers of instances
  ElementRules rules_;                                          // of the types in the deck
  bool byType_ = false;                                         // an element has two of them
  std::vector<DeckMaterial> materials_;
  std::vector<DeckSection> sections_;
  std::vector<DeckStructure> structures_;
  std::map<std::string, std::vector<DeckLink>> links_;  // by their ELSET, as nodeSets_
  const DeckLinkType* linkType_ = nullptr;
  std::vector<DeckProperty> properties_;
  std::vector<DeckScaling> scalings_;
  std::vector<std::vector<const DeckScaling*>> scalingOfElement_;  // [block][element]
  std::vector<DeckRigid> rigids_;
  std::set<std::string> loadsSeen_;  // keywords
  std::set<std::int64_t> ownNodes_;  // numbers of the nodes of the assembly
  static constexpr std::string_view ofAssembly = "node of the assembly ";
  std::map<std::string, std::string> points_;  // of node sets, as nodeSets_: pointOf the only node, or severalNodes
  std::optional<std::size_t> viscosityAt_;     // of *BULK VISCOSITY
  std::optional<std::size_t> scaledForAt_;     // of variable mass scaling
  std::map<std::string, Surface> surfaces_;
  Surface* surface_ = nullptr;
  std::vector<DeckContact> contacts_;
  std::optional<std::size_t> general_;  // of contacts_: the one of *CONTACT
  std::string interaction_, generalInteraction_;
  std::map<std::string, double> frictions_;  // by *SURFACE INTERACTION
  std::map<std::string, std::size_t> frictionAt_;
  std::vector<DeckInitial> initials_;
  std::map<std::string, DeckAmplitude> amplitudes_;
  DeckAmplitude* amplitude_ = nullptr;
  std::set<std::string> noted_;
};

}  // namespace

bool isDeckFile(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  if (file.extension() == ".inp") return true;  // what is wrong with it its reader says
  const std::string begin = detail::beginOfFile(file);
  return detail::startsWithDeck(begin) || detail::startsWithDyna(begin);
}

DeckScene readDeckScene(const std::filesystem::path& file, DeckUse use) {
  return detail::startsWithDyna(detail::beginOfFile(file)) ? readDynaScene(file, use) : DeckReader(file, use).read();
}

}  // namespace ringwatch
