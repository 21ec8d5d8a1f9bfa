#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/base/units.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// history.csv of a run, by columns.
struct RunHistory {
  struct Column {
    std::string name;            // in SI, whatever the head of the file names: "safe_s"
    std::vector<double> values;  // one a row; NaN where the cell is empty
  };
  std::vector<Column> columns;            // those of numbers
  std::vector<std::string> elements;      // "block:element", each once
  std::vector<std::string> numbers;       // of them in the mesh file; empty where these are not known
  std::vector<std::int32_t> controlling;  // of each row: into `elements`, -1 for none
  std::vector<std::string> verdicts;      // of each row, "" for none
  Units units = Units::si;                // of the heads of its columns
  std::vector<std::string> notes;         // what was wrong with the file, one line each

  std::size_t rowCount() const { return verdicts.size(); }
  /// What a page calls one of `elements`.
  const std::string& nameOf(std::int32_t element) const {
    return numbers.empty() ? elements[element] : numbers[element];
  }
  /// nullptr when the file has no such column.
  const std::vector<double>* column(std::string_view name) const;
};

/// Reads history.csv in a run's folder; empty when there is none. A last row that does not end, as a killed run may
/// leave it, and rows with another number of cells than the head are left out with a note. Throws InputError when the
/// file is no history at all.
std::optional<RunHistory> readRunHistory(const std::filesystem::path& folder);

/// The element that "block:element" names; empty for another text.
std::optional<ElementRef> elementAt(std::string_view name);
/// Finds the file's numbers of the elements, where the mesh has some.
void numberElements(RunHistory& history, const Mesh& mesh);

/// Rows of a history, ascending, of which a picture shows what all rows would show: the first and the last one, and of
/// each bucket of rows those with the least and the largest value of each column, the first one that is not finite, and
/// the first one of each verdict. All rows when there are at most `most`, else hardly more than that.
std::vector<std::size_t> rowsForPicture(const RunHistory& history, std::size_t most);

/// A history of these rows alone.
RunHistory selected(const RunHistory& history, const std::vector<std::size_t>& rows);

}  // namespace ringwatch
