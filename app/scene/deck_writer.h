#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/app/scene/deck_faces.h>
#include <ringwatch/app/scene/deck_keywords.h>
#include <ringwatch/app/scene/deck_scene.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/formats/deck_lines.h>
#include <ringwatch/meshes/number_index.h>

namespace ringwatch {

/// What is held or moved of degrees of freedom by a line of a deck.
struct DeckBoundary {
  std::string selection;       // a set, or "#12"
  std::string components;      // "xy"
  std::string turns = {};      // about these axes, likewise; of what has rotations
  std::string point = {};      // of one node: which
  double value = 0;            // m, or m/s
  bool velocity = false;       // value is one
  std::string amplitude = {};  // the name of its table; "" for none
  std::size_t position = 0;
};
struct DeckLoad {
  std::string selection;
  Eigen::Vector3d value;  // N at each node, m/s² with `acceleration`
  bool acceleration = false;
  std::string point = {};     // as of DeckBoundary
  std::string elements = {};  // the set that an acceleration names
  std::string amplitude = {};
  std::size_t position = 0;
};

/// The scene that a deck becomes while it is read, whatever its dialect: sections, notes, what is left out and refused.
class DeckWriter {
 protected:
  using Json = nlohmann::ordered_json;
  /// Entries of a scene for a table of time, or the factor of one that is constant.
  struct Table {
    Json entries = Json::object();
    double factor = 1;
  };

  DeckWriter(const std::filesystem::path& file, DeckUse use, detail::DeckDialect dialect);
  virtual ~DeckWriter() = default;
  DeckWriter(const DeckWriter&) = delete;
  DeckWriter& operator=(const DeckWriter&) = delete;

  /// The table with a name; position: of what names it, for messages.
  virtual Table tableOf(const std::string& amplitude, std::size_t position) const = 0;
  /// Likewise of a displacement, which begins at 0.
  virtual Table displacementTable(const DeckBoundary& held) const = 0;

  bool forRun() const { return use_ == DeckUse::run; }
  void note(std::string text) { scene_.notes.push_back(std::move(text)); }
  void refuse(std::size_t position, const std::string& what);
  /// Throws InputError with all that was refused, if anything was.
  void throwRefused() const;
  /// keyword: without the star.
  void leaveOut(std::string_view keyword, std::size_t position);
  /// "line 12", with the file where it is an included one.
  std::string placeOf(std::size_t position) const;
  /// Does what the table says of a keyword, "*ELEMENT", or of a parameter of one. False where it is refused.
  bool follow(DeckRule rule, std::string_view keyword, std::string_view parameter, std::string_view why,
              std::size_t position);

  const Mesh& mesh();
  /// Of that mesh.
  NumberIndex& numbers();
  /// The nodes of a selection: a set, or "#" and a number. Empty for one that is not there, which the scene refuses.
  std::vector<std::int32_t> nodesOf(const std::string& selection);
  const DeckFaces& faces();

  /// A pressure (Pa, inwards) on faces, each a face of faces(), of a line below the keyword at `position`.
  void press(const std::vector<std::int32_t>& faces, double pressure, const std::string& amplitude,
             std::size_t position);

  bool presses() const { return !pressures_.empty(); }
  std::size_t firstPressure() const { return pressures_.front().position; }

  /// Adds an entry of a list; one that differs from the last in its nodes alone, each named by its number, joins it.
  void addEntry(const std::string& section, const std::string& selection, const Json& rest, std::size_t position);
  /// The next entry of a list joins none before it.
  void keepApart(const std::string& section) { last_.erase(section); }
  static Json listOf(const Eigen::Vector3d& v) { return Json{v[0], v[1], v[2]}; }
  /// Of the materials of the parts of the body, at least one, with where each stands.
  void writeMaterialList(Json list, const std::vector<std::string>& origins);
  void writeBoundaries();
  /// Contact by penalty of the nodes of each side with the faces of the other, "#3,7" each; of all surfaces without.
  void addContact(const Json& entry, const std::string& nodes, const std::string& faces, bool nodesHaveFaces,
                  std::size_t position);
  void writeLoad(const DeckLoad& load);

  /// Pressure waves in elements of the mesh.
  struct Waves {
    std::vector<ElementRef> elements;
    double speed, density;  // m/s, kg/m³
  };
  /// Of an entry of a material with its law; what: of it, for messages.
  void addWaves(const Json& entry, std::vector<ElementRef> elements, const std::string& what, std::size_t position);
  /// What the elements' own steps are: of each the crossing of its volume over its largest face, of a tetrahedron of
  /// its least height, by a wave.
  struct Crossings {
    double least = infinity;       // s
    std::int64_t controlling = 0;  // the number of its element
    std::size_t count = 0, scaled = 0;
    double mass = 0, added = 0;  // kg
  };
  /// Adds point masses where an own step is below `step` (s; 0 for none): as much as would give the element, by its
  /// density, that step. elements: those that may get mass; nullptr for all. keyword: for messages.
  Crossings scaleMasses(double step, const std::set<ElementRef>* elements, std::string_view keyword,
                        std::size_t position);
  void writePressures();
  /// The scene with the note of what was left out.
  DeckScene finished();

  std::filesystem::path file_;
  DeckUse use_;
  std::string text_;
  detail::DeckLines lines_;
  DeckScene scene_;
  std::vector<DeckBoundary> boundaries_;
  std::vector<DeckLoad> loads_;
  std::vector<std::string> refused_;
  std::vector<Waves> waves_;  // of the elements that are not rigid

 private:
  struct Pressure {
    double value;  // Pa, inwards
    std::string amplitude;
    std::size_t position;  // of the keyword
    std::vector<std::int32_t> faces = {};
  };
  struct Last {
    std::string key;              // "" where none may join it
    std::set<std::string> nodes;  // each "#12"
  };

  std::vector<Pressure> pressures_;
  std::set<std::int32_t> pressed_;
  std::optional<Mesh> mesh_;
  std::optional<NumberIndex> numbers_;
  std::optional<DeckFaces> faces_;
  std::map<std::string, Last> last_;  // entries of the sections
  bool contactIsTold_ = false;
  std::string left_;
};

}  // namespace ringwatch
