#include <ringwatch/app/scene/dyna_scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/scene/deck_writer.h>
#include <ringwatch/app/scene/dyna_keywords.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/formats/dyna_cards.h>

namespace ringwatch {
namespace {

using detail::DeckLine;
using detail::DynaCard;
using detail::DynaKeyword;
using detail::DynaLayout;
using Json = nlohmann::ordered_json;

// What LS-DYNA has unless a card says otherwise (Keyword User's Manual, *CONTROL_TIMESTEP, *CONTROL_BULK_VISCOSITY,
// *CONTROL_HOURGLASS, *MAT_BLATZ-KO_RUBBER).
constexpr double usualStepFactor = 0.9, usualQuadratic = 1.5, usualLinear = 0.06, usualHourglass = 0.1;
constexpr double poissonOfBlatzKo = 0.463;
/// Hourglass controls up to this one are viscous, those above are of stiffness.
constexpr std::int64_t lastViscous = 3, lastHourglass = 10;
/// IDRFLG of no relaxation, whatever curves say.
constexpr std::int64_t noRelaxation = -999;
/// Times at which nothing ends.
constexpr double never = 1e20;

/// Codes of constraints of *NODE and *MAT_RIGID: components.
constexpr std::array<std::string_view, 8> heldBy{"", "x", "y", "z", "xy", "yz", "xz", "xyz"};

struct DynaPart {
  std::int64_t section, material, equation, hourglass;
  std::size_t position;
};
struct DynaHourglass {
  std::int64_t type = 0;
  double coefficient = 0;  // 0 for the usual one
  std::size_t position = 0;
};
/// What holds or moves a rigid part.
struct DynaGuide {
  std::string held;          // components
  std::int64_t turning = 0;  // code of what does not turn
  std::size_t position = 0;
};
struct DynaMaterial {
  const DynaLawEntry* law;  // nullptr for one that is not taken
  std::string keyword;
  std::size_t position;
  Json given;  // model and parameters
  double density = 0;
  DynaGuide guide = {};
};
struct DynaCurve {
  std::vector<double> times, values;
  std::size_t position;
};
/// A motion of a rigid part along an axis.
struct DynaRigidMotion {
  std::int64_t part;
  DeckBoundary motion;  // components: one
};

class DynaReader : DeckWriter {
 public:
  DynaReader(const std::filesystem::path& file, DeckUse use)
      : DeckWriter(file, use, detail::DeckDialect::dyna), keywords_(lines_) {}

  DeckScene read() {
    while (const std::optional<DeckLine> line = lines_.next()) {
      if (line->isKeyword()) {
        finishKeyword();
        begin(*line);
      } else {
        data(*line);
      }
    }
    finishKeyword();
    throwRefused();
    (void)mesh();  // a deck without solids is refused as a mesh
    scene_.sections["mesh"] = Json{{"file", file_.filename().string()}};
    scene_.origins["mesh"] = file_.string();
    writeMaterials();
    writeDamping();
    writeIntegrator();
    writeRigidParts();
    std::erase_if(boundaries_, [&](const DeckBoundary& held) { return isOfOthers(held.selection, held.position); });
    std::erase_if(loads_, [&](const DeckLoad& load) { return isOfOthers(load.selection, load.position); });
    writeBoundaries();
    for (const auto& write : later_) write();
    for (const DeckLoad& load : loads_) writeLoad(load);
    writePressures();
    throwRefused();
    tellStep();
    if (others_ > 0)
      note(fmt::format("{}: {} supports, loads, masses or velocities left out, which are of nodes of no solid element",
                       file_.string(), others_));
    for (const auto& [keyword, count] : structures_)
      note(fmt::format(
          "{}: *{}, {} {}: elements that are no solids are left out, and the body is without their stiffness "
          "and mass",
          lines_.where(count.second), keyword, count.first,
          keyword == "ELEMENT_SHELL" || keyword == "ELEMENT_BEAM" ? "of them" : "lines"));
    return finished();
  }

 private:
  struct Handler {
    std::string_view keyword;
    void (DynaReader::*read)();
    std::size_t most = 0;  // cards that the keyword has, of those that have a number of them
  };
  static const Handler handlers[], ofMaterials;

  void begin(const DeckLine& line) {
    keyword_ = keywords_.read(line);
    cards_.clear();
    handler_ = nullptr;
    const std::string& name = keyword_.name;
    const bool ofMaterial = name.starts_with("MAT_") && !name.starts_with("MAT_ADD_");
    const DynaLawEntry* law = ofMaterial ? findDynaLaw(std::string_view(name).substr(4)) : nullptr;
    const DeckKeywordRule* rule = findKeywordRule(dynaKeywords(), name);
    if (law == nullptr) {
      if (refusedKeywords_.contains(name)) return;
      const bool isTaken = rule != nullptr && follow(rule->rule, name, "", rule->why, line.position);
      if (rule == nullptr) refuse(line.position, fmt::format("*{} is not known", shortened(name)));
      if (!isTaken) {
        refusedKeywords_.insert(name);
        return;
      }
    }
    if (ofMaterial && (law != nullptr || rule->rule == DeckRule::harmless)) handler_ = &ofMaterials;
    if (rule != nullptr && (rule->rule == DeckRule::mesh || rule->rule == DeckRule::taken ||
                            (rule->rule == DeckRule::takenInRun && forRun())))
      if (const auto* own =
              std::find_if(handlers, handlers + handlerCount, [&](const Handler& one) { return one.keyword == name; });
          own != handlers + handlerCount)
        handler_ = own;
    if (isStructure(name)) structures_.try_emplace(name, 0, line.position);
  }
  static bool isStructure(std::string_view name) {
    return name.starts_with("ELEMENT_SHELL") || name.starts_with("ELEMENT_BEAM");
  }
  void data(const DeckLine& line) {
    if (handler_ != nullptr) {
      cards_.push_back(line);
    } else if (keyword_.name == "NODE") {
      constrainNode(line);
    } else if (const auto own = structures_.find(keyword_.name); own != structures_.end()) {
      ++own->second.first;
    }
  }
  void finishKeyword() {
    if (handler_ == nullptr) return;
    requireAtMost(handler_->most);
    (this->*handler_->read)();
    handler_ = nullptr;
  }
  /// Fails at a card behind the ones that the keyword has; 0 for any number.
  void requireAtMost(std::size_t most) const {
    if (most > 0 && cardCount() > most && !nothingFollows(cards_.size() - cardCount() + most))
      lines_.failAt(card(most).position(),
                    fmt::format("*{}: has {}; what is behind it takes a keyword of its own", keyword_.name,
                                most == 1 ? "one line" : fmt::format("{} lines", most)));
  }

  /// Card i of the keyword, behind its title.
  DynaCard card(std::size_t i, DynaLayout layout = DynaLayout::usual) const {
    const std::size_t at = i + (keyword_.titled ? 1 : 0);
    if (at < cards_.size()) return {lines_, keyword_, cards_[at], layout};
    if (i == 0) lines_.failAt(keyword_.position, fmt::format("*{} has no card", keyword_.name));
    return {lines_, keyword_, {std::string_view(), keyword_.position, true}, layout};  // one of blanks
  }
  std::size_t cardCount() const { return cards_.size() - std::min<std::size_t>(cards_.size(), keyword_.titled); }
  /// Calls each(card, next) for the entries of a keyword that has many, of some cards each; next(i): the i-th card
  /// behind the first. titles: a line before each entry.
  template <class Each>
  void forEachEntry(std::size_t perEntry, bool titles, DynaLayout layout, const Each& each) {
    for (std::size_t i = 0; i < cards_.size();) {
      if (titles) ++i;
      if (i >= cards_.size()) break;
      // A line of blanks gives nothing, but as the first of several cards of an entry, whose fields all have defaults.
      if (cards_[i].text.empty() && (perEntry == 1 || (i > 0 && nothingFollows(i)))) {
        ++i;
        continue;
      }
      const auto next = [&](std::size_t k) {
        return i + k < cards_.size()
                   ? DynaCard(lines_, keyword_, cards_[i + k], layout)
                   : DynaCard(lines_, keyword_, {std::string_view(), keyword_.position, true}, layout);
      };
      each(DynaCard(lines_, keyword_, cards_[i], layout), next);
      i += perEntry;
    }
  }
  bool nothingFollows(std::size_t i) const {
    return std::all_of(cards_.begin() + static_cast<std::ptrdiff_t>(i), cards_.end(),
                       [](const DeckLine& line) { return line.text.empty(); });
  }
  template <class Each>
  void forEachCard(const Each& each) {
    forEachEntry(1, keyword_.titled, DynaLayout::usual, [&](const DynaCard& card, const auto&) { each(card); });
  }
  /// Refuses a field that says something which is not done.
  void requireZero(const DynaCard& card, std::size_t i, std::string_view name, std::string_view why) {
    if (card.real(i, name) != 0)
      refuse(card.position(), fmt::format("*{}, {} = {}: {}", keyword_.name, name, card.field(i), why));
  }
  /// A factor that is 1 where the field is blank or zero.
  static double scaleOf(const DynaCard& card, std::size_t i, std::string_view name) {
    const double value = card.real(i, name);
    return value == 0 ? 1 : value;
  }
  /// Of a keyword of which a deck has one: keeps where it stands.
  void once(std::optional<std::size_t>& at, const DynaCard& card) {
    if (at)
      refuse(card.position(),
             fmt::format("*{} gives a second time what {} gives; leave one out", keyword_.name, placeOf(*at)));
    at = card.position();
  }
  template <class Map>
  void refuseSecond(const Map& known, std::int64_t id, const DynaCard& card) {
    if (known.contains(id))
      refuse(card.position(), fmt::format("*{} {} gives a second time what {} gives; leave one out", keyword_.name, id,
                                          placeOf(known.at(id).position)));
  }

  // The model.

  void part() {
    forEachEntry(1, true, DynaLayout::usual, [&](const DynaCard& card, const auto&) {
      const std::int64_t id = card.id(0, "PID");
      requireZero(card, 5, "GRAV", "begins with the stress of its weight");
      requireZero(card, 6, "ADPOPT", "makes elements along a run");
      refuseSecond(parts_, id, card);
      parts_.insert_or_assign(id, DynaPart{card.whole(1, "SECID"), card.whole(2, "MID"), card.whole(3, "EOSID"),
                                           card.whole(4, "HGID"), card.position()});
    });
  }
  void section() {
    forEachCard([&](const DynaCard& card) {
      const std::int64_t id = card.id(0, "SECID");
      requireZero(card, 2, "AET", "is of meshes that move through the body");
      if (!forms_.try_emplace(id, card.whole(1, "ELFORM", 1)).second)
        refuse(card.position(), fmt::format("*SECTION_SOLID {} stands a second time; leave one out", id));
    });
  }
  void hourglass() {
    forEachCard([&](const DynaCard& card) {
      const std::int64_t id = card.id(0, "HGID");
      refuseSecond(hourglasses_, id, card);
      hourglasses_.insert_or_assign(id, DynaHourglass{hourglassType(card, 1), card.real(2, "QM"), card.position()});
      for (const auto& [field, name] : {std::pair<std::size_t, const char*>{4, "Q1"}, {5, "Q2"}})
        if (card.real(field, name) != 0) ofPart_.push_back({field == 4, card.real(field, name), card.position()});
    });
  }
  void controlHourglass() {
    const DynaCard own = card(0);
    once(hourglassAt_, own);
    hourglass_ = {hourglassType(own, 0), own.real(1, "QH"), own.position()};
  }
  static std::int64_t hourglassType(const DynaCard& card, std::size_t field) {
    const std::int64_t type = card.whole(field, "IHQ");
    if (type < 0 || type > lastHourglass) card.fail(field, "IHQ", fmt::format("0 to {}", lastHourglass));
    return type;
  }

  void material() {
    const DynaCard first = card(0);
    const std::int64_t id = first.id(0, "MID");
    refuseSecond(materials_, id, first);
    DynaMaterial material{findDynaLaw(std::string_view(keyword_.name).substr(4)), keyword_.name, keyword_.position,
                          Json::object()};
    if (material.law != nullptr) {
      requireAtMost(material.law->cards);
      material.density = first.real(1, "RO");
      material.given = Json{{"model", material.law->model}};
      switch (material.law->law) {
        case DynaLaw::elastic:
          material.given["young"] = first.real(2, "E");
          material.given["poisson"] = first.real(3, "PR");
          break;
        case DynaLaw::blatzKo:
          requireZero(first, 3, "REF", notFromReference);
          material.given["young"] = 2 * (1 + poissonOfBlatzKo) * first.real(2, "G");
          material.given["poisson"] = poissonOfBlatzKo;
          break;
        case DynaLaw::mooneyRivlin:
          requireZero(first, 5, "REF", notFromReference);
          if (first.real(3, "A") == 0 && first.real(4, "B") == 0)
            refuse(first.position(), fmt::format("*{}: A and B are 0: {}", keyword_.name, notFitted));
          rubber(material.given, first.real(3, "A"), first.real(4, "B"), first);
          break;
        case DynaLaw::hyperelastic:
          hyperelastic(material.given, first);
          break;
        case DynaLaw::ogden:
          ogden(material.given, first);
          break;
        case DynaLaw::rigid:
          rigid(material, first);
          break;
      }
    }
    materials_.insert_or_assign(id, std::move(material));
  }
  static constexpr std::string_view notFromReference = "begins with the strain from another geometry",
                                    notFitted = "constants are not fitted; give those that LS-DYNA prints",
                                    notViscous = "there are no viscous and frictional shares of a law";

  /// W = c10 (I1 - 3) + c01 (I2 - 3) + K/2 (J - 1)², K from PR and the shear modulus 2 (c10 + c01).
  void rubber(Json& law, double c10, double c01, const DynaCard& card) {
    const double poisson = card.real(2, "PR"), shear = 2 * (c10 + c01);
    if (!(poisson > 0 && poisson < 0.5)) card.fail(2, "PR", "> 0 and < 0.5; an incompressible body has no step");
    law["c10"] = c10;
    law["c01"] = c01;
    law["bulk"] = 2 * shear * (1 + poisson) / (3 * (1 - 2 * poisson));
  }
  /// The fields of both laws of the first card, and what of the viscous cards behind the constants is not done.
  void rubberCards(const DynaCard& first, std::size_t constants) {
    requireZero(first, 3, "N", notFitted);
    requireZero(first, 4, "NV", notViscous);
    requireZero(first, 5, "G", notViscous);
    requireZero(first, 6, "SIGF", notViscous);
    requireZero(first, 7, "REF", notFromReference);
    for (std::size_t i = 1 + constants; i < cardCount(); ++i)
      for (const auto& [field, name] : {std::pair<std::size_t, const char*>{0, "GI"}, {2, "GJ"}})
        requireZero(card(i), field, name, notViscous);
  }
  void hyperelastic(Json& law, const DynaCard& first) {
    rubberCards(first, 1);
    const DynaCard constants = card(1);
    static constexpr std::string_view names[] = {"C10", "C01", "C11", "C20", "C02", "C30"};
    std::array<double, std::size(names)> c{};
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = constants.real(i, names[i]);
    requireZero(constants, 6, "THERML", "there are no temperatures");
    if (first.real(3, "N") != 0) return;
    const bool yeoh = c[3] != 0 || c[5] != 0;
    for (const std::size_t i : {2, 4, 1})
      if (c[i] != 0 && (yeoh || i != 1))
        return refuse(constants.position(),
                      fmt::format("*{}: {} is not 0: of its terms C10 and C01 are taken, or C10, C20 and C30",
                                  keyword_.name, names[i]));
    rubber(law, c[0], c[1], first);
    law["model"] = yeoh ? "yeoh" : "mooney-rivlin";
    if (!yeoh) return;
    law.erase("c01");
    law["c20"] = c[3];
    law["c30"] = c[5];
  }
  /// Terms with the exponents 2 and -2 are those of Mooney and Rivlin: mu/alpha Σ (λ^alpha - 1).
  void ogden(Json& law, const DynaCard& first) {
    rubberCards(first, 2);
    if (first.real(3, "N") != 0) return;
    const DynaCard factors = card(1), exponents = card(2);
    double c10 = 0, c01 = 0;
    constexpr std::size_t terms = 8;
    for (std::size_t i = 0; i < terms; ++i) {
      const double mu = factors.real(i, fmt::format("MU{}", i + 1)),
                   alpha = exponents.real(i, fmt::format("ALPHA{}", i + 1));
      if (mu == 0) continue;
      if (std::abs(alpha) != 2)
        return refuse(exponents.position(), fmt::format("*{}: ALPHA{} = {:.6g}: terms with 2 and -2 are taken, which "
                                                        "are those of mooney-rivlin",
                                                        keyword_.name, i + 1, alpha));
      (alpha > 0 ? c10 : c01) += mu / alpha;
    }
    rubber(law, c10, c01, first);
  }
  void rigid(DynaMaterial& material, const DynaCard& first) {
    material.given = Json{{"model", "corotational"}, {"young", first.real(2, "E")}, {"poisson", first.real(3, "PR")}};
    for (const auto& [field, name] : {std::pair<std::size_t, const char*>{4, "N"}, {5, "COUPLE"}, {6, "M"}})
      requireZero(first, field, name, "moves with another program");
    const DynaCard own = card(1);
    const double kind = own.real(0, "CMO");
    if (kind == 0) return;
    if (kind != 1) return refuse(own.position(), "*MAT_RIGID, CMO = -1: holds it in turned axes; 1 and 0 are taken");
    const std::int64_t held = own.whole(1, "CON1"), turning = own.whole(2, "CON2");
    if (held < 0 || held >= static_cast<std::int64_t>(heldBy.size())) own.fail(1, "CON1", "0 to 7");
    if (turning < 0 || turning >= static_cast<std::int64_t>(heldBy.size())) own.fail(2, "CON2", "0 to 7");
    material.guide = {std::string(heldBy[static_cast<std::size_t>(held)]), turning, own.position()};
  }

  void constrainNode(const DeckLine& line) {
    constexpr std::size_t code = 4, beforeCode = 56;  // columns of the standard format
    if (line.text.size() <= beforeCode && line.text.find(',') == std::string_view::npos) return;
    const DynaCard card(lines_, keyword_, line, DynaLayout::node);
    const std::int64_t held = card.whole(code, "TC");
    if (held == 0) return;
    if (held < 0 || held >= static_cast<std::int64_t>(heldBy.size())) card.fail(code, "TC", "0 to 7");
    boundaries_.push_back({.selection = fmt::format("#{}", card.id(0, "NID")),
                           .components = std::string(heldBy[static_cast<std::size_t>(held)]),
                           .position = line.position});
  }
  void pointMass() {
    forEachEntry(1, keyword_.titled, DynaLayout::mass, [&](const DynaCard& card, const auto&) {
      const std::string node = fmt::format("#{}", card.id(1, "NID"));
      const double mass = card.real(2, "MASS");
      if (mass == 0) return;
      later_.emplace_back([this, node, mass, position = card.position()] {
        if (isOfOthers(node, position)) return;
        keepApart("mass");  // the mass of an entry is that of all its nodes
        addEntry("mass", node, {{"mass", mass}}, position);
      });
    });
  }

  /// Whether a selection is of nodes of elements alone that are left out, or of parts of them; counts those.
  bool isOfOthers(const std::string& selection, std::size_t position) {
    if (structures_.empty() || selection.empty()) return false;
    if (ofSolids_.empty()) {
      ofSolids_.resize(mesh().nodeCount(), false);
      for (const MeshBlock& block : mesh().blocks)
        for (const std::int32_t node : block.connectivity) ofSolids_[static_cast<std::size_t>(node)] = true;
    }
    const std::vector<std::int32_t> nodes = nodesOf(selection);
    const auto isPartThatIs = [&] {
      constexpr std::string_view part = "part-", partSet = "partset-";
      if (selection.starts_with(part)) requirePart(std::stoll(selection.substr(part.size())), position);
      return selection.starts_with(part) ||
             (selection.starts_with(partSet) && partSets_.contains(std::stoll(selection.substr(partSet.size()))));
    };
    const bool isOther = nodes.empty() ? isPartThatIs() : std::ranges::none_of(nodes, [&](std::int32_t node) {
      return ofSolids_[static_cast<std::size_t>(node)];
    });
    if (isOther) ++others_;
    return isOther;
  }

  void partSet() {
    partSets_.insert(card(0).id(0, "SID"));
    if (keyword_.name.ends_with("_GENERATE")) return;
    for (std::size_t i = 1; i < cardCount(); ++i) {
      const DynaCard own = card(i);
      for (std::size_t field = 0; field < own.size(); ++field)
        if (const std::int64_t part = own.whole(field, "PID"); part != 0)
          later_.emplace_back([this, part, at = own.position()] { requirePart(part, at); });
    }
  }

  // What is held, moved and loaded.

  bool ofSet() const { return keyword_.name.ends_with("_SET"); }
  /// The nodes that field i names.
  std::string nodesNamed(const DynaCard& card, std::size_t i) const {
    return ofSet() ? detail::dynaNodeSet(card.id(i, "NSID")) : fmt::format("#{}", card.id(i, "NID"));
  }
  static constexpr std::string_view turnedAxes = "turns the axes";

  void support() {
    forEachCard([&](const DynaCard& card) {
      requireZero(card, 1, "CID", turnedAxes);
      DeckBoundary held{.selection = nodesNamed(card, 0), .components = "", .position = card.position()};
      static constexpr std::pair<char, const char*> components[] = {{'x', "DOFX"}, {'y', "DOFY"}, {'z', "DOFZ"}};
      for (std::size_t i = 0; i < std::size(components); ++i)
        if (const std::int64_t flag = card.whole(2 + i, components[i].second); flag == 1)
          held.components += components[i].first;
        else if (flag != 0)
          card.fail(2 + i, components[i].second, "0 or 1");
      if (!held.components.empty()) boundaries_.push_back(held);
    });
  }
  void motion() {
    const bool ofRigid = keyword_.name.ends_with("_RIGID");
    forEachCard([&](const DynaCard& card) {
      const std::int64_t dof = card.whole(1, "DOF"), kind = card.whole(2, "VAD");
      if (dof < 1 || dof > 3)
        return refuse(card.position(), fmt::format("*{}, DOF = {}: 1, 2 and 3 are taken", keyword_.name, dof));
      if (kind != 0 && kind != 2)
        return refuse(card.position(), fmt::format("*{}, VAD = {}: 0 for a velocity and 2 for a displacement are taken",
                                                   keyword_.name, kind));
      requireZero(card, 5, "VID", turnedAxes);
      requireZero(card, 7, "BIRTH", "begins within the run");
      if (card.real(6, "DEATH") != 0 && card.real(6, "DEATH") < never)
        refuse(card.position(), fmt::format("*{}, DEATH = {}: ends within the run", keyword_.name, card.field(6)));
      DeckBoundary moved{.selection = ofRigid ? "" : nodesNamed(card, 0),
                         .components = std::string(1, static_cast<char>('x' + dof - 1)),
                         .value = scaleOf(card, 4, "SF"),
                         .velocity = kind == 0,
                         .amplitude = std::to_string(card.id(3, "LCID")),
                         .position = card.position()};
      if (ofRigid)
        rigidMotions_.push_back({card.id(0, "PID"), moved});
      else
        boundaries_.push_back(moved);
    });
  }
  void initialVelocity() {
    const DynaCard first = card(0), second = card(1);
    requireZero(first, 1, "NSIDEX", "leaves nodes out of a set; write the set without them");
    requireZero(first, 2, "BOXID", "is of nodes in a box; write a set of them");
    requireZero(first, 4, "ICID", turnedAxes);
    const std::int64_t set = first.whole(0, "NSID");
    begins(set == 0 ? "" : detail::dynaNodeSet(set), second, 0, first.position());
  }
  void initialVelocityOfNodes() {
    forEachCard([&](const DynaCard& card) {
      requireZero(card, 7, "ICID", turnedAxes);
      begins(fmt::format("#{}", card.id(0, "NID")), card, 1, card.position());
    });
  }
  void begins(const std::string& selection, const DynaCard& card, std::size_t first, std::size_t position) {
    Eigen::Vector3d velocity;
    static constexpr std::string_view names[] = {"VX", "VY", "VZ", "VXR", "VYR", "VZR"};
    for (std::size_t i = 0; i < 3; ++i) {
      velocity[static_cast<Eigen::Index>(i)] = card.real(first + i, names[i]);
      requireZero(card, first + i + 3, names[i + 3], "a solid's nodes do not turn");
    }
    addInitial(selection, Json{{"velocity", listOf(velocity)}}, position);
  }
  void initialVelocityGeneration() {
    forEachEntry(2, keyword_.titled, DynaLayout::usual, [&](const DynaCard& first, const auto& next) {
      const DynaCard second = next(1);
      const std::int64_t id = first.whole(0, "ID"), kind = first.whole(1, "STYP");
      if (id != 0 && (kind < 1 || kind > 3)) first.fail(1, "STYP", "1 of a part set, 2 of a part or 3 of a node set");
      requireZero(first, 7, "ICID", turnedAxes);
      requireZero(second, 6, "PHASE", "begins within the run");
      const auto vector = [](const DynaCard& card, std::size_t begin, std::string_view letter) {
        Eigen::Vector3d value;
        for (std::size_t i = 0; i < 3; ++i)
          value[static_cast<Eigen::Index>(i)] = card.real(begin + i, fmt::format("{}{}", letter, "XYZ"[i]));
        return value;
      };
      Json entry{{"velocity", listOf(vector(first, 3, "V"))}};
      if (const double rate = first.real(2, "OMEGA"); rate != 0) {
        const Eigen::Vector3d axis = vector(second, 3, "N");
        if (axis.isZero(0) || second.real(3, "NX") == -999)
          second.fail(3, "NX", "that of the direction of the axis, of NX, NY and NZ");
        entry["angular_velocity"] = listOf(rate * axis.normalized());
        Eigen::Vector3d point;
        static constexpr std::string_view names[] = {"XC", "YC", "ZC"};
        for (std::size_t i = 0; i < 3; ++i) point[static_cast<Eigen::Index>(i)] = second.real(i, names[i]);
        entry["point"] = listOf(point);
      }
      addInitial(id == 0     ? ""
                 : kind == 1 ? detail::dynaPartSet(id)
                 : kind == 2 ? detail::dynaPart(id)
                             : detail::dynaNodeSet(id),
                 entry, first.position());
    });
  }
  void addInitial(const std::string& selection, const Json& entry, std::size_t position) {
    if (!forRun()) return;
    later_.emplace_back([this, selection, entry, position] {
      if (isOfOthers(selection, position)) return;
      begun_.resize(mesh().nodeCount(), 0);
      const auto take = [&](std::int32_t node) {
        std::size_t& by = begun_[static_cast<std::size_t>(node)];
        if (by != 0)
          lines_.failAt(position,
                        fmt::format("*INITIAL_VELOCITY: node {} has a velocity already, by {}; give each node "
                                    "its velocity once",
                                    mesh().nodeId(node), placeOf(by - 1)));
        by = position + 1;
      };
      if (selection.empty())
        for (std::int32_t node = 0; node < static_cast<std::int32_t>(mesh().nodeCount()); ++node) take(node);
      else
        for (const std::int32_t node : nodesOf(selection)) take(node);
      addEntry("initial", selection, entry, position);
    });
  }

  void nodalLoad() {
    forEachCard([&](const DynaCard& card) {
      const std::int64_t dof = card.whole(1, "DOF");
      if (dof < 1 || dof > 3)
        return refuse(card.position(),
                      fmt::format("*{}, DOF = {}: forces along 1, 2 and 3 are taken", keyword_.name, dof));
      requireZero(card, 4, "CID", turnedAxes);
      loads_.push_back({.selection = nodesNamed(card, 0),
                        .value = scaleOf(card, 3, "SF") * Eigen::Vector3d::Unit(dof - 1),
                        .amplitude = std::to_string(card.id(2, "LCID")),
                        .position = card.position()});
    });
  }
  /// The acceleration is that of the ground: the body's own is against it.
  void bodyLoad() {
    const DynaCard own = card(0);
    once(bodyLoadAt_[static_cast<std::size_t>(keyword_.name.back() - 'X')], own);
    requireZero(own, 6, "CID", turnedAxes);
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
    acceleration[keyword_.name.back() - 'X'] = -scaleOf(own, 1, "SF");
    loads_.push_back({.selection = "",
                      .value = acceleration,
                      .acceleration = true,
                      .amplitude = std::to_string(own.id(0, "LCID")),
                      .position = own.position()});
  }
  struct Segment {
    std::array<std::int64_t, 4> nodes;
    std::size_t position;
  };
  static Segment segmentOf(const DynaCard& card, std::size_t first) {
    Segment segment{{}, card.position()};
    static constexpr std::string_view names[] = {"N1", "N2", "N3", "N4"};
    for (std::size_t i = 0; i < 3; ++i) segment.nodes[i] = card.id(first + i, names[i]);
    segment.nodes[3] = card.isBlank(first + 3) || card.whole(first + 3, names[3]) == 0 ? segment.nodes[2]
                                                                                       : card.id(first + 3, names[3]);
    return segment;
  }
  void segmentSet() {
    const DynaCard first = card(0);
    const std::int64_t id = first.id(0, "SID");
    const auto [entry, isNew] = segments_.try_emplace(id);
    if (!isNew) return refuse(first.position(), fmt::format("*SET_SEGMENT {} stands a second time; leave one out", id));
    for (std::size_t i = 1; i < cardCount(); ++i)
      if (const DynaCard own = card(i); own.size() > 0) entry->second.push_back(segmentOf(own, 0));
  }
  void segmentLoad() {
    const bool set = ofSet();
    forEachCard([&](const DynaCard& card) {
      const std::size_t curve = set ? 1 : 0;
      requireZero(card, curve + 2, "AT", "begins within the run");
      const std::string amplitude = std::to_string(card.id(curve, "LCID"));
      const double factor = scaleOf(card, curve + 1, "SF");
      const std::int64_t id = set ? card.id(0, "SSID") : 0;
      std::vector<Segment> own;
      if (!set) own.push_back(segmentOf(card, 3));
      later_.emplace_back([this, own, id, set, factor, amplitude, at = card.position(), name = keyword_.name] {
        const std::vector<Segment>* segments = &own;
        if (set) {
          const auto found = segments_.find(id);
          if (found == segments_.end()) lines_.failAt(at, fmt::format("*{}: there is no *SET_SEGMENT {}", name, id));
          segments = &found->second;
        }
        for (const Segment& segment : *segments) pressSegment(segment, factor, amplitude, at);
      });
    });
  }
  /// A pressure pushes against the normal that the order of the corners has.
  void pressSegment(const Segment& segment, double factor, const std::string& amplitude, std::size_t position) {
    const auto [face, outwards] = faceOf(segment);
    press({face}, outwards ? factor : -factor, amplitude, position);
  }
  /// Its face, and whether its corners go round it as seen from outside.
  std::pair<std::int32_t, bool> faceOf(const Segment& segment) {
    std::vector<std::int32_t> corners;
    for (std::size_t i = 0; i < (segment.nodes[3] == segment.nodes[2] ? 3U : 4U); ++i) {
      const std::vector<std::int32_t> node = nodesOf(fmt::format("#{}", segment.nodes[i]));
      if (node.empty())
        lines_.failAt(segment.position,
                      fmt::format("the segment holds node {}, which the mesh does not have", segment.nodes[i]));
      corners.push_back(node.front());
    }
    const auto face = faces().findByCorners(corners);
    if (!face)
      lines_.failAt(segment.position, fmt::format("the segment {}: no face of the body's surface has these corners",
                                                  fmt::join(segment.nodes, " ")));
    return *face;
  }

  void curve() {
    const DynaCard first = card(0);
    const std::int64_t id = first.id(0, "LCID");
    refuseSecond(curves_, id, first);
    requireZero(first, 1, "SIDR", "is of dynamic relaxation, which loads the body before the run");
    const double ofTime = scaleOf(first, 2, "SFA"), ofValue = scaleOf(first, 3, "SFO"), time = first.real(4, "OFFA"),
                 value = first.real(5, "OFFO");
    DynaCurve made{{}, {}, first.position()};
    for (std::size_t i = 1; i < cardCount(); ++i) {
      const DynaCard point = card(i, DynaLayout::points);
      if (point.size() == 0) continue;
      made.times.push_back(ofTime * (point.real(0, "A1") + time));
      made.values.push_back(ofValue * (point.real(1, "O1") + value));
    }
    if (made.times.empty()) lines_.failAt(first.position(), fmt::format("*DEFINE_CURVE {} has no points", id));
    curves_.insert_or_assign(id, std::move(made));
  }
  const DynaCurve& curveOf(const std::string& name, std::size_t position) const {
    const auto found = curves_.find(std::stoll(name));
    if (found == curves_.end()) lines_.failAt(position, fmt::format("there is no *DEFINE_CURVE {}", name));
    return found->second;
  }
  Table tableOf(const std::string& amplitude, std::size_t position) const override {
    const DynaCurve& curve = curveOf(amplitude, position);
    const bool constant =
        std::ranges::all_of(curve.values, [&](double value) { return value == curve.values.front(); });
    // What LS-DYNA does beyond the ends of a curve is not for a load.
    if (curve.times.front() > 0 || curve.times.back() < end_)
      lines_.failAt(curve.position,
                    fmt::format("*DEFINE_CURVE {} has times from {:.6g} to {:.6g} s; it must have those "
                                "of the whole run, 0 to {:.6g} s",
                                amplitude, curve.times.front(), curve.times.back(), end_));
    if (constant) return {Json::object(), curve.values.front()};
    return {Json{{"times", curve.times}, {"factors", curve.values}}};
  }
  Table displacementTable(const DeckBoundary& held) const override {
    Table table = tableOf(held.amplitude, held.position);
    if (table.entries.empty() || curveOf(held.amplitude, held.position).values.front() != 0)
      lines_.failAt(
          curveOf(held.amplitude, held.position).position,
          fmt::format("*DEFINE_CURVE {} of a displacement must begin with 0, or the nodes would jump to their "
                      "place at once",
                      held.amplitude));
    return table;
  }

  // Contact.

  /// A side of a contact: its nodes, "#3,7", "" for all, and whether it has faces.
  struct Side {
    std::string nodes;
    bool hasFaces = true;
  };
  Side sideOf(std::int64_t id, std::int64_t kind, const std::string& keyword, std::size_t position) {
    constexpr std::int64_t segments = 0, partSet = 2, part = 3, nodeSet = 4, all = 5;
    const auto refuseSide = [&](const std::string& what) {
      lines_.failAt(position, fmt::format("*{}: {}", keyword, what));
    };
    if (kind == all || (id == 0 && kind != nodeSet)) return {};
    if (kind == nodeSet) {
      std::set<std::int64_t> numbers;
      for (const std::int32_t node : nodesOf(detail::dynaNodeSet(id))) numbers.insert(mesh().nodeId(node));
      if (numbers.empty()) refuseSide(fmt::format("there is no *SET_NODE {}", id));
      return {fmt::format("#{}", fmt::join(numbers, ",")), false};
    }
    std::set<std::int32_t> own;
    if (kind == segments) {
      const auto found = segments_.find(id);
      if (found == segments_.end()) refuseSide(fmt::format("there is no *SET_SEGMENT {}", id));
      for (const Segment& segment : found->second) own.insert(faceOf(segment).first);
    } else if (kind == part || kind == partSet) {
      const std::string name = kind == part ? detail::dynaPart(id) : detail::dynaPartSet(id);
      const auto found = mesh().elementSets.find(name);
      if (found == mesh().elementSets.end()) refuseSide(fmt::format("{} has no solid elements", name));
      if (found->second.size() == mesh().elementCount()) return {};
      const std::vector<std::int32_t> faces = this->faces().ofElements(found->second);
      own.insert(faces.begin(), faces.end());
    } else {
      refuseSide(fmt::format("sides of type {} are not taken; 0, 2, 3, 4 and 5 are", kind));
    }
    const std::vector<std::string> sets = faces().nodeSetsOf({own.begin(), own.end()});
    if (sets.size() != 1) refuseSide("the faces of a side are not told from others by their nodes");
    return {sets.front()};
  }
  void contact() {
    const std::string name = keyword_.name;
    const DynaCard sides = card(0), friction = card(1);
    for (const auto& [field, what] : {std::pair<std::size_t, const char*>{4, "SBOXID"}, {5, "MBOXID"}})
      requireZero(sides, field, what, "is of a box; write a set");
    const double coefficient = friction.real(0, "FS");
    if (coefficient < 0) refuse(friction.position(), fmt::format("*{}, FS < 0: is of tables", name));
    if (friction.real(2, "DC") != 0 && friction.real(1, "FD") != coefficient)
      refuse(friction.position(),
             fmt::format("*{}, FD and DC: there is one coefficient of friction for all speeds", name));
    requireZero(friction, 3, "VC", "there is one coefficient of friction for all pressures");
    requireZero(friction, 6, "BT", "begins within the run");
    for (const auto& [field, what] : {std::pair<std::size_t, const char*>{6, "FSF"}, {7, "VSF"}})
      if (scaleOf(card(2), field, what) != 1)
        refuse(card(2).position(),
               fmt::format("*{}, {} = {}: scales friction; write the product", name, what, card(2).field(field)));
    if (const double death = friction.real(7, "DT"); death != 0 && death < never)
      refuse(friction.position(), fmt::format("*{}, DT: ends within the run", name));
    constexpr std::size_t mandatory = 3;
    if (cardCount() > mandatory && !nothingFollows(cards_.size() - cardCount() + mandatory))
      note(fmt::format("{}: *{}: the lines behind its third are of LS-DYNA's own search and penalty, and left out",
                       lines_.where(card(mandatory).position()), name));
    constexpr double percent = 100;
    Json entry{{"with", "surface"}};
    if (coefficient != 0) entry["friction"] = coefficient;
    if (const double share = friction.real(4, "VDC"); share != 0) entry["damping"] = share / percent;
    const bool single = name.ends_with("_SINGLE_SURFACE"), ofNodes = name.ends_with("NODES_TO_SURFACE");
    const std::array<std::int64_t, 4> given{sides.whole(0, "SSID"), sides.whole(1, "MSID"), sides.whole(2, "SSTYP"),
                                            sides.whole(3, "MSTYP")};
    later_.emplace_back([this, entry, name, single, ofNodes, given, at = sides.position()] {
      const Side one = sideOf(given[0], given[2], name, at);
      if (single) return addContact(entry, one.nodes, one.nodes, false, at);
      const Side other = sideOf(given[1], given[3], name, at);
      if (!other.hasFaces) lines_.failAt(at, fmt::format("*{}: MSID is a set of nodes, which has no faces", name));
      if (one.nodes.empty() || other.nodes.empty())
        lines_.failAt(at,
                      fmt::format("*{}: a side is the whole body; *CONTACT_AUTOMATIC_SINGLE_SURFACE is of all", name));
      addContact(entry, one.nodes, other.nodes, one.hasFaces && !ofNodes, at);
    });
  }

  void wall() {
    forEachEntry(2, keyword_.titled, DynaLayout::usual, [&](const DynaCard& first, const auto& next) {
      const DynaCard second = next(1);
      requireZero(first, 1, "NSIDEX", "leaves nodes out of a set; write the set without them");
      requireZero(first, 2, "BOXID", "is of nodes in a box; write a set of them");
      requireZero(first, 3, "OFFSET", "is of nodes within a distance; write a set of them");
      requireZero(first, 4, "BIRTH", "begins within the run");
      if (const double death = first.real(5, "DEATH"); death != 0 && death < never)
        refuse(first.position(), "*RIGIDWALL_PLANAR, DEATH: ends within the run");
      requireZero(second, 7, "WVEL", "is of a speed of waves");
      Eigen::Vector3d tail, head;
      for (std::size_t i = 0; i < 3; ++i) {
        tail[static_cast<Eigen::Index>(i)] = second.real(i, fmt::format("{}T", "XYZ"[i]));
        head[static_cast<Eigen::Index>(i)] = second.real(3 + i, fmt::format("{}H", "XYZ"[i]));
      }
      if (tail == head) second.fail(3, "XH", "with YH and ZH another point than that of XT, YT and ZT");
      const double friction = second.real(6, "FRIC");
      if (friction < 0 || friction >= 1) second.fail(6, "FRIC", ">= 0 and < 1, a coefficient of friction");
      const std::string name = fmt::format("wall-{}", ++walls_);
      Json plane{{"kind", "plane"}, {"name", name}, {"point", listOf(tail)}, {"normal", listOf(head - tail)}};
      Json contact{{"obstacle", name}};
      if (friction != 0) contact["friction"] = friction;
      const std::int64_t set = first.whole(0, "NSID");
      later_.emplace_back([this, plane, contact, set, at = first.position()] {
        if (forRun())
          note(
              fmt::format("{}: *RIGIDWALL_PLANAR: it stops nodes by penalty here, and they part from it; in LS-DYNA it "
                          "takes their speed against it",
                          lines_.where(at)));
        addEntry("obstacle", "", plane, at);
        keepApart("contact");
        addEntry("contact", set == 0 ? "" : detail::dynaNodeSet(set), contact, at);
      });
    });
  }

  // Damping and the step.

  void globalDamping() {
    const DynaCard own = card(0);
    requireZero(own, 0, "LCID", "changes the damping along the run");
    std::set<double> factors;
    static constexpr std::string_view names[] = {"STX", "STY", "STZ"};
    for (std::size_t i = 0; i < 3; ++i) factors.insert(own.real(2 + i, names[i]));
    if (factors != std::set<double>{0} && factors != std::set<double>{1})
      refuse(own.position(), "*DAMPING_GLOBAL, STX, STY, STZ: damping is the same along all axes here");
    once(massDampingAt_, own);
    massDamping_ = own.real(1, "VALDMP");
  }
  void stiffnessDamping() {
    forEachCard([&](const DynaCard& card) {
      const double share = card.real(1, "COEF");
      if (share > 0)
        refuse(card.position(), fmt::format("*DAMPING_PART_STIFFNESS, COEF = {}: a share of LS-DYNA's own measure; a "
                                            "time of Rayleigh damping, COEF < 0, is taken",
                                            card.field(1)));
      const std::int64_t id = card.id(0, "PID");
      refuseSecond(stiffnessDamping_, id, card);
      stiffnessDamping_.insert_or_assign(id, PartDamping{-share, card.position()});
    });
  }
  void bulkViscosity() {
    const DynaCard own = card(0);
    if (const std::int64_t type = own.whole(2, "TYPE"); type != 0 && type != 1)
      refuse(own.position(), fmt::format("*{}, TYPE = {}: 1 is taken", keyword_.name, type));
    if (const double q = own.real(0, "Q1"); q != 0) quadratic_ = q;
    if (const double q = own.real(1, "Q2"); q != 0) linear_ = q;
    once(viscosityAt_, own);
  }
  void writeDamping() {
    for (const auto& [isQuadratic, value, position] : ofPart_)
      if (value != (isQuadratic ? quadratic_ : linear_))
        lines_.failAt(position, fmt::format("*HOURGLASS, {} = {}: bulk viscosity is of the whole body here; give it by "
                                            "*CONTROL_BULK_VISCOSITY",
                                            isQuadratic ? "Q1" : "Q2", value));
    Json damping{
        {"bulk_viscosity", true}, {"linear_bulk_viscosity", linear_}, {"quadratic_bulk_viscosity", quadratic_}};
    if (massDamping_ != 0) damping["mass"] = massDamping_;
    scene_.sections["damping"] = std::move(damping);
    scene_.origins["damping"] = viscosityAt_ ? lines_.where(*viscosityAt_) : file_.string();
    if (massDampingAt_) scene_.origins["damping.mass"] = lines_.where(*massDampingAt_);
    note(
        fmt::format("{}: bulk viscosity {} and {}{}: the linear part acts in tension too here, in LS-DYNA under "
                    "compression alone; damping.bulk_viscosity = false takes both out",
                    scene_.origins["damping"], linear_, quadratic_, viscosityAt_ ? "" : ", which LS-DYNA has unasked"));
  }

  void termination() {
    const DynaCard own = card(0);
    once(endAt_, own);
    end_ = own.real(0, "ENDTIM");
    if (!forRun()) return;
    requireZero(own, 1, "ENDCYC", "ends the run at a number of steps; ENDTIM ends it");
    requireZero(own, 3, "ENDENG", "may end the run by its energy");
  }
  void timestep() {
    const DynaCard own = card(0), second = card(1);
    once(stepAt_, own);
    if (const double factor = own.real(1, "TSSFAC"); factor != 0) stepFactor_ = factor;
    if (stepFactor_ < 0) own.fail(1, "TSSFAC", ">= 0; below it is the number of a curve, which is not followed");
    scaledStep_ = own.real(4, "DT2MS");
    if (scaledStep_ > 0)
      refuse(own.position(), fmt::format("*CONTROL_TIMESTEP, DT2MS = {}: gives every element the same step, also those "
                                         "that need no mass; DT2MS < 0 is taken",
                                         own.field(4)));
    requireZero(second, 0, "DT2MSF", "scales masses; DT2MS < 0 is taken");
    requireZero(second, 1, "DT2MSLC", "scales masses by a curve; DT2MS < 0 is taken");
    requireZero(second, 2, "IMSCL", "scales masses by a matrix");
    if (forRun()) requireZero(own, 6, "ERODE", "takes elements out of the body; [erosion] of a scene does that");
    for (const auto& [field, name] : {std::pair<std::size_t, const char*>{0, "DTINIT"}, {5, "LCTM"}}) {
      if (own.real(field, name) == 0) continue;
      stepDependsOn_.push_back(name);
      if (forRun())
        note(fmt::format("{}: *CONTROL_TIMESTEP, {}: it does not bound the step, which is as large as is proven",
                         lines_.where(own.position()), name));
    }
  }
  /// What a run is not.
  void analysis() {
    struct Switch {
      std::string_view keyword;
      std::size_t field;
      std::string_view name, why;
    };
    static constexpr Switch switches[] = {
        {"CONTROL_SOLUTION", 0, "SOLN", "is of heat"},
        {"CONTROL_DYNAMIC_RELAXATION", 7, "IDRFLG", "relaxes the body before the run"},
        {"CONTROL_IMPLICIT_GENERAL", 0, "IMFLAG", "is implicit, and the scheme here is explicit"}};
    const auto* own = std::ranges::find(switches, keyword_.name, &Switch::keyword);
    if (own->name == "IDRFLG" && card(0).whole(own->field, own->name) == noRelaxation) return;
    requireZero(card(0), own->field, own->name, own->why);
  }
  void writeIntegrator() {
    Json& integrator = scene_.sections["integrator"] = Json{{"step", "auto"}, {"end", forRun() ? end_ : 1.0}};
    scene_.origins["integrator"] = endAt_ ? lines_.where(*endAt_) : file_.string();
    if (!forRun()) return;
    if (!endAt_)
      throw InputError(
          fmt::format("{}: has no *CONTROL_TERMINATION, and so no motion to run; ringwatch inspect tells "
                      "the step that its body can take",
                      file_.string()));
    integrator["safety"] = stepFactor_;
    if (stepAt_) scene_.origins["integrator.safety"] = lines_.where(*stepAt_);
  }

  /// LS-DYNA's own step (Theory Manual, "Time Step Calculations for Solid Elements"), and the mass for that of DT2MS.
  void tellStep() {
    const std::size_t position = stepAt_.value_or(0);
    const std::string where = stepAt_ ? lines_.where(position) : file_.string();
    const Crossings all = scaleMasses(-scaledStep_, nullptr, "CONTROL_TIMESTEP, DT2MS", position);
    if (!std::isfinite(all.least)) return;
    if (!structures_.empty()) stepDependsOn_.push_back("the elements that are no solids");
    if (std::ranges::any_of(forms_, [](const auto& form) { return form.second == 16 || form.second == 17; }))
      stepDependsOn_.push_back("ELFORM 16 and 17");
    if (!stepDependsOn_.empty())
      note(fmt::format("{}: LS-DYNA's own step may depend on {} besides, and gets no verdict", where,
                       fmt::join(stepDependsOn_, ", ")));
    else
      scene_.ownStep = stepFactor_ * (all.scaled == 0 ? all.least : -scaledStep_);
    const std::string crossing = fmt::format(
        "{:.6g} x {:.6g} = {:.6g} s, TSSFAC times the least crossing of an element by a wave, of element {}",
        stepFactor_, all.least, stepFactor_ * all.least, all.controlling);
    if (all.scaled == 0)
      note(fmt::format("{}: LS-DYNA's own step at rest is {}; the proven one is that of the bracket", where, crossing));
    if (scaledStep_ == 0) return;
    if (all.scaled == 0)
      return note(
          fmt::format("{}: *CONTROL_TIMESTEP, DT2MS: adds no mass at rest, since no element's step is below "
                      "{:.6g} s",
                      where, -scaledStep_));
    note(
        fmt::format("{}: *CONTROL_TIMESTEP, DT2MS: LS-DYNA adds {:.6g} kg to {} of {} elements at rest, {:.3g} % of "
                    "{:.6g} kg, and steps at {:.6g} s; without that mass its step would be {}; the proven one is that "
                    "of the bracket of the body with this mass at their nodes, and none that LS-DYNA adds later",
                    where, all.added, all.scaled, all.count, 100 * all.added / all.mass, all.mass,
                    -stepFactor_ * scaledStep_, crossing));
  }

  // Parts.

  std::string ruleOf(const DynaPart& part, std::string_view element) {
    const auto form = forms_.find(part.section);
    if (form == forms_.end())
      lines_.failAt(part.position, fmt::format("*PART: there is no *SECTION_SOLID {}", part.section));
    const std::span<const DynaSolid> rows = dynaSolids(form->second);
    const auto named = [&] { return fmt::format("*SECTION_SOLID {}, ELFORM = {}", part.section, form->second); };
    if (rows.empty()) lines_.failAt(part.position, named() + ": there is no such element");
    if (rows.front().element.empty()) lines_.failAt(part.position, fmt::format("{}: {}", named(), rows.front().why));
    const auto row = std::ranges::find(rows, element, &DynaSolid::element);
    if (row == rows.end())
      lines_.failAt(part.position, fmt::format("{}: it is no formulation of the {} of this part", named(), element));
    if (!row->why.empty() && noted_.insert(fmt::format("{} {}", form->second, element)).second)
      note(fmt::format("{}: {}: {} with {}: {}", lines_.where(part.position), named(), element, row->rule, row->why));
    return std::string(row->rule);
  }
  /// Hourglass control of a part of one-point hexahedra, as keys of its material.
  void hourglassOf(const DynaPart& part, Json& entry) {
    DynaHourglass own = hourglass_;
    if (part.hourglass != 0) {
      const auto found = hourglasses_.find(part.hourglass);
      if (found == hourglasses_.end())
        lines_.failAt(part.position, fmt::format("*PART: there is no *HOURGLASS {}", part.hourglass));
      if (found->second.type != 0) own.type = found->second.type;
      if (found->second.coefficient != 0) own.coefficient = found->second.coefficient;
      own.position = found->second.position;
    }
    const bool viscous = own.type <= lastViscous;
    if (hourglassIsViscous_ && *hourglassIsViscous_ != viscous)
      lines_.failAt(part.position,
                    "*PART: hourglass control is viscous in one part and of stiffness in another; one of "
                    "the two is for all here");
    hourglassIsViscous_ = viscous;
    if (viscous) {
      entry["hourglass_stiffness"] = 0.0;
      entry["hourglass_viscosity"] = own.coefficient == 0 ? usualHourglass : own.coefficient;
    } else if (noted_.insert("hourglass").second) {
      note(fmt::format("{}: IHQ = {}: {}", lines_.where(own.position), own.type, hourglassHere));
    }
  }

  void writeMaterials() {
    Json list = Json::array();
    std::vector<std::string> origins;
    constexpr std::string_view prefix = "part-";
    std::set<std::int64_t> solid;  // by number, so that the order is that of the numbers
    for (const auto& [set, elements] : mesh().elementSets)
      if (set.starts_with(prefix) && !elements.empty()) solid.insert(std::stoll(set.substr(prefix.size())));
    for (const std::int64_t id : solid) {
      const auto found = parts_.find(id);
      if (found == parts_.end())
        throw InputError(
            fmt::format("{}: there are elements of part {}, and no *PART {}{}", file_.string(), id, id,
                        forRun() ? "" : "; give a law to take the mesh alone: --young, --poisson, --density"));
      const DynaPart& part = found->second;
      const auto given = materials_.find(part.material);
      if (given == materials_.end())
        lines_.failAt(part.position, fmt::format("*PART: there is no *MAT_ {}", part.material));
      const DynaMaterial& material = given->second;
      if (part.equation != 0)
        lines_.failAt(part.position, fmt::format("*PART, EOSID = {}: there are no equations of state", part.equation));
      if (material.law == nullptr)
        lines_.failAt(material.position, fmt::format("*{} of part {}: {}", material.keyword, id, noLaw));
      Json entry = material.given;
      entry["set"] = detail::dynaPart(id);
      entry["density"] = material.density;
      if (material.law->law == DynaLaw::rigid) {
        rigidParts_.emplace(id, material.guide);
      } else {
        std::set<std::string_view> kinds;
        for (const ElementRef element : mesh().elementSets.at(detail::dynaPart(id)))
          kinds.insert(elementInfo(mesh().blocks[element.block].type).name);
        for (const std::string_view kind : kinds) {
          const std::string rule = ruleOf(part, kind);
          entry["rules"].push_back(fmt::format("{}={}", kind, rule));
          if (rule == "uniform-strain") hourglassOf(part, entry);
        }
        if (const auto damping = stiffnessDamping_.find(id); damping != stiffnessDamping_.end())
          entry["stiffness_damping"] = damping->second.time;
        if (forRun() && !material.law->why.empty() && noted_.insert(material.keyword).second)
          note(fmt::format("{}: *{} is {}: {}", lines_.where(material.position), material.keyword,
                           entry["model"].get<std::string>(), material.law->why));
        addWaves(entry, mesh().elementSets.at(detail::dynaPart(id)), "*" + material.keyword,
                 material.position);  // for LS-DYNA's own step
      }
      list.push_back(std::move(entry));
      origins.push_back(lines_.where(material.position));
    }
    writeMaterialList(std::move(list), origins);
    for (const auto& [id, damping] : stiffnessDamping_) {
      requirePart(id, damping.position);
      if (rigidParts_.contains(id) || !solid.contains(id))
        note(fmt::format("{}: *DAMPING_PART_STIFFNESS of part {}, which {}: left out", lines_.where(damping.position),
                         id, solid.contains(id) ? "is rigid" : "has no solid elements"));
    }
  }
  /// A part of other elements than solids is one too.
  void requirePart(std::int64_t id, std::size_t position) const {
    if (!parts_.contains(id)) lines_.failAt(position, fmt::format("there is no *PART {}", id));
  }
  void writeRigidParts() {
    for (const auto& [id, guide] : rigidParts_) {
      const std::string name = detail::dynaPart(id);
      addEntry("rigid", name, {{"name", name}}, parts_.at(id).position);
      std::vector<DeckBoundary> motions;
      for (const DynaRigidMotion& one : rigidMotions_)
        if (one.part == id) motions.push_back(one.motion);
      writeGuide(name, guide, motions);
    }
    for (const DynaRigidMotion& one : rigidMotions_)
      if (!rigidParts_.contains(one.part))
        lines_.failAt(one.motion.position,
                      fmt::format("*BOUNDARY_PRESCRIBED_MOTION_RIGID: part {} is not rigid", one.part));
  }
  void writeGuide(const std::string& name, const DynaGuide& guide, const std::vector<DeckBoundary>& motions) {
    std::string components = guide.held;
    for (const DeckBoundary& one : motions)
      if (components.find(one.components) == std::string::npos) components += one.components;
    if (motions.size() > 1)
      lines_.failAt(motions[1].position, fmt::format("*BOUNDARY_PRESCRIBED_MOTION_RIGID: a second motion of {}; one is "
                                                     "of a rigid part here",
                                                     name));
    const std::string_view stays = heldBy[static_cast<std::size_t>(guide.turning)];
    if (components.empty() && stays.empty()) return;
    if (components.empty() || stays.size() == 1)
      lines_.failAt(guide.position, fmt::format("*MAT_RIGID, CON1 and CON2: {} of {} are not held alone here; hold a "
                                                "displacement as well, and two rotations, three or none",
                                                stays.size() == 1 ? "single rotations" : "rotations", name));
    Json entry{{"rigid", name}, {"components", components}};
    if (stays != "xyz") entry["turns"] = true;
    if (stays.size() == 2)
      for (const char c : {'x', 'y', 'z'})
        if (stays.find(c) == std::string_view::npos) entry["axis"] = listOf(Eigen::Vector3d::Unit(c - 'x'));
    if (motions.empty() || !forRun())
      return addEntry("fix", "", entry, motions.empty() ? guide.position : motions.front().position);
    const DeckBoundary& motion = motions.front();
    const Table table = motion.velocity ? tableOf(motion.amplitude, motion.position) : displacementTable(motion);
    entry[motion.velocity ? "velocity" : "displacement"] =
        listOf(table.factor * motion.value * Eigen::Vector3d::Unit(motion.components[0] - 'x'));
    entry.update(table.entries);
    addEntry("move", "", entry, motion.position);
  }

  static const std::size_t handlerCount;
  detail::DynaKeywords keywords_;
  DynaKeyword keyword_;
  std::vector<DeckLine> cards_;       // of the keyword
  const Handler* handler_ = nullptr;  // of the keyword at hand
  std::map<std::int64_t, DynaPart> parts_;
  std::vector<std::string> stepDependsOn_;      // besides crossings, LS-DYNA's own step
  std::map<std::int64_t, std::int64_t> forms_;  // of *SECTION_SOLID
  std::map<std::int64_t, DynaHourglass> hourglasses_;
  DynaHourglass hourglass_;
  std::optional<bool> hourglassIsViscous_;
  std::map<std::int64_t, DynaMaterial> materials_;
  std::map<std::int64_t, DynaCurve> curves_;
  std::map<std::int64_t, std::vector<Segment>> segments_;
  struct PartDamping {
    double time;  // s
    std::size_t position;
  };
  std::map<std::int64_t, PartDamping> stiffnessDamping_;  // of parts
  std::map<std::int64_t, DynaGuide> rigidParts_;
  std::vector<DynaRigidMotion> rigidMotions_;
  struct OfPart {
    bool isQuadratic;
    double value;
    std::size_t position;
  };
  std::vector<OfPart> ofPart_;                // bulk viscosity by *HOURGLASS
  std::vector<std::function<void()>> later_;  // entries that need the mesh, and sets below
  std::vector<std::size_t> begun_;            // of each node: 1 + where its initial velocity stands; 0: none
  std::map<std::string, std::pair<std::int64_t, std::size_t>> structures_;  // keyword -> number, first position
  std::set<std::int64_t> partSets_;                                         // of any parts
  std::vector<bool> ofSolids_;                                              // of each node, once asked for
  int walls_ = 0, others_ = 0;
  double massDamping_ = 0, quadratic_ = usualQuadratic, linear_ = usualLinear;
  double end_ = 0, stepFactor_ = usualStepFactor, scaledStep_ = 0;
  std::optional<std::size_t> massDampingAt_, viscosityAt_, hourglassAt_, endAt_, stepAt_;
  std::array<std::optional<std::size_t>, 3> bodyLoadAt_;  // along x, y and z
  std::set<std::string> noted_, refusedKeywords_;
};

constexpr std::size_t contactCards = 3 + 7;  // A to G behind those that each contact has

const DynaReader::Handler DynaReader::handlers[] = {
    {"PART", &DynaReader::part},
    {"SECTION_SOLID", &DynaReader::section},
    {"HOURGLASS", &DynaReader::hourglass},
    {"ELEMENT_MASS", &DynaReader::pointMass},
    {"CONTROL_TERMINATION", &DynaReader::termination, 1},
    {"CONTROL_TIMESTEP", &DynaReader::timestep},
    {"CONTROL_BULK_VISCOSITY", &DynaReader::bulkViscosity, 1},
    {"CONTROL_HOURGLASS", &DynaReader::controlHourglass, 1},
    {"CONTROL_SOLUTION", &DynaReader::analysis, 1},
    {"CONTROL_DYNAMIC_RELAXATION", &DynaReader::analysis},
    {"CONTROL_IMPLICIT_GENERAL", &DynaReader::analysis},
    {"BOUNDARY_SPC_NODE", &DynaReader::support},
    {"BOUNDARY_SPC_SET", &DynaReader::support},
    {"BOUNDARY_PRESCRIBED_MOTION_NODE", &DynaReader::motion},
    {"BOUNDARY_PRESCRIBED_MOTION_SET", &DynaReader::motion},
    {"BOUNDARY_PRESCRIBED_MOTION_RIGID", &DynaReader::motion},
    {"INITIAL_VELOCITY", &DynaReader::initialVelocity, 2},
    {"INITIAL_VELOCITY_NODE", &DynaReader::initialVelocityOfNodes},
    {"INITIAL_VELOCITY_GENERATION", &DynaReader::initialVelocityGeneration},
    {"DAMPING_GLOBAL", &DynaReader::globalDamping, 1},
    {"DAMPING_PART_STIFFNESS", &DynaReader::stiffnessDamping},
    {"DEFINE_CURVE", &DynaReader::curve},
    {"LOAD_NODE_POINT", &DynaReader::nodalLoad},
    {"LOAD_NODE_SET", &DynaReader::nodalLoad},
    {"LOAD_BODY_X", &DynaReader::bodyLoad, 1},
    {"LOAD_BODY_Y", &DynaReader::bodyLoad, 1},
    {"LOAD_BODY_Z", &DynaReader::bodyLoad, 1},
    {"LOAD_SEGMENT", &DynaReader::segmentLoad},
    {"LOAD_SEGMENT_SET", &DynaReader::segmentLoad},
    {"SET_PART", &DynaReader::partSet},
    {"SET_PART_LIST", &DynaReader::partSet},
    {"SET_PART_LIST_GENERATE", &DynaReader::partSet},
    {"SET_SEGMENT", &DynaReader::segmentSet},
    {"RIGIDWALL_PLANAR", &DynaReader::wall},
    {"CONTACT_AUTOMATIC_SINGLE_SURFACE", &DynaReader::contact, contactCards},
    {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", &DynaReader::contact, contactCards},
    {"CONTACT_AUTOMATIC_NODES_TO_SURFACE", &DynaReader::contact, contactCards},
    {"CONTACT_SURFACE_TO_SURFACE", &DynaReader::contact, contactCards},
    {"CONTACT_NODES_TO_SURFACE", &DynaReader::contact, contactCards},
};
const DynaReader::Handler DynaReader::ofMaterials{"MAT", &DynaReader::material};
const std::size_t DynaReader::handlerCount = std::size(handlers);

}  // namespace

DeckScene readDynaScene(const std::filesystem::path& file, DeckUse use) { return DynaReader(file, use).read(); }

}  // namespace ringwatch
