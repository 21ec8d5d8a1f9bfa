#include <ringwatch/app/report/run_history.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/formats/file_cursor.h>

namespace ringwatch {
namespace {

std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

/// The columns of a history by their names in a system of units.
struct NamedColumns {
  Units units;
  std::map<std::string, std::string_view, std::less<>> columns;
};
const std::vector<NamedColumns>& columnsOfSystems() {
  static const std::vector<NamedColumns> all = [] {
    std::vector<NamedColumns> made;
    for (const auto& system : unitSystems) {
      NamedColumns& of = made.emplace_back(NamedColumns{system.value, {}});
      for (const OutputField& column : historyColumns())
        of.columns.emplace(labelledColumns(std::string(column.name), system.value), column.name);
    }
    return made;
  }();
  return all;
}

/// The names of columns as they are in SI; units: those that most of them name.
std::vector<std::string> inSi(const std::vector<std::string_view>& head, Units& units) {
  std::vector<std::string> best;
  std::size_t most = 0;
  for (const NamedColumns& system : columnsOfSystems()) {
    std::vector<std::string> names(head.begin(), head.end());
    std::size_t known = 0;
    for (std::string& name : names)
      if (const auto column = system.columns.find(name); column != system.columns.end()) name = column->second, ++known;
    if (known > most || best.empty()) best = std::move(names), most = known, units = system.units;
  }
  return best;
}

double numberIn(std::string_view cell) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

}  // namespace

const std::vector<double>* RunHistory::column(std::string_view name) const {
  for (const Column& column : columns)
    if (column.name == name) return &column.values;
  return nullptr;
}

std::optional<RunHistory> readRunHistory(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "history.csv";
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const std::string text = detail::readWholeFile(file);
  const std::size_t headEnd = text.find('\n');
  const std::string_view all(text);
  RunHistory history;
  const std::vector<std::string> head = inSi(cellsOf(all.substr(0, std::min(headEnd, text.size()))), history.units);
  if (head.size() < 3 || head[0] != "step" || head[1] != "time_s" || head[2] != "h_s")
    throw InputError(fmt::format("{}:1: begins with {}; the history of a run begins with step,time_s,h_s",
                                 file.string(), inQuotes(std::string(all.substr(0, std::min(headEnd, text.size()))))));
  std::vector<std::ptrdiff_t> columnOf;  // of `columns`; -1: the controlling element, -2: the verdict
  for (const std::string& name : head) {
    if (name == "controlling_element" || name == "verdict") {
      columnOf.push_back(name == "verdict" ? -2 : -1);
      continue;
    }
    columnOf.push_back(history.columns.size());
    history.columns.push_back({name, {}});
  }
  std::map<std::string, std::int32_t, std::less<>> numberOf;
  std::size_t damaged = 0;
  for (std::size_t begin = headEnd; begin != std::string::npos && begin + 1 < text.size();) {
    ++begin;
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) {
      history.notes.emplace_back("history.csv ends within a row, as when a run is killed; that row is left out");
      break;
    }
    const std::vector<std::string_view> cells = cellsOf(all.substr(begin, end - begin));
    begin = end;
    if (cells.size() != head.size() || std::isnan(numberIn(cells[1]))) {
      ++damaged;
      continue;
    }
    std::int32_t controlling = -1;
    std::string verdict;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (columnOf[c] >= 0) {
        history.columns[columnOf[c]].values.push_back(numberIn(cells[c]));
      } else if (columnOf[c] == -2) {
        verdict = std::string(cells[c]);
      } else if (!cells[c].empty()) {
        const auto found = numberOf.find(cells[c]);
        if (found != numberOf.end()) {
          controlling = found->second;
        } else {
          controlling = static_cast<std::int32_t>(history.elements.size());
          numberOf.emplace(std::string(cells[c]), controlling);
          history.elements.emplace_back(cells[c]);
        }
      }
    }
    history.controlling.push_back(controlling);
    history.verdicts.push_back(std::move(verdict));
  }
  if (damaged > 0) history.notes.push_back(fmt::format("{} damaged rows of history.csv are left out", damaged));
  return history;
}

std::optional<ElementRef> elementAt(std::string_view name) {
  ElementRef ref;
  const char* const end = name.data() + name.size();
  const auto [colon, fault] = std::from_chars(name.data(), end, ref.block);
  if (fault != std::errc() || colon == end || *colon != ':') return std::nullopt;
  const auto [last, wrong] = std::from_chars(colon + 1, end, ref.element);
  return wrong == std::errc() && last == end && ref.block >= 0 && ref.element >= 0 ? std::optional(ref) : std::nullopt;
}

void numberElements(RunHistory& history, const Mesh& mesh) {
  std::vector<std::string> numbers;
  for (const std::string& name : history.elements) {
    const auto ref = elementAt(name);
    if (!ref || static_cast<std::size_t>(ref->block) >= mesh.blocks.size()) return;
    const MeshBlock& block = mesh.blocks[ref->block];
    if (static_cast<std::size_t>(ref->element) >= block.ids.size()) return;
    numbers.push_back(fmt::format("{}", block.ids[ref->element]));
  }
  history.numbers = std::move(numbers);
}

std::vector<std::size_t> rowsForPicture(const RunHistory& history, std::size_t most) {
  const std::size_t rows = history.rowCount();
  std::vector<std::size_t> kept;
  if (rows <= most) {
    for (std::size_t i = 0; i < rows; ++i) kept.push_back(i);
    return kept;
  }
  // At most two rows a column and bucket, one in practice: columns have their extremes in the same rows.
  const std::size_t perBucket = 2 * history.columns.size() + 3;
  const std::size_t buckets = std::max<std::size_t>(1, most / perBucket);
  kept = {0, rows - 1};
  for (std::size_t b = 0; b < buckets; ++b) {
    const std::size_t begin = rows * b / buckets, end = rows * (b + 1) / buckets;
    for (const RunHistory::Column& column : history.columns) {
      std::size_t least = end, largest = end, notFinite = end;
      for (std::size_t i = begin; i < end; ++i) {
        const double value = column.values[i];
        if (!std::isfinite(value)) {
          notFinite = std::min(notFinite, i);
          continue;
        }
        if (least == end || value < column.values[least]) least = i;
        if (largest == end || value > column.values[largest]) largest = i;
      }
      for (const std::size_t i : {least, largest, notFinite})
        if (i < end) kept.push_back(i);
    }
    std::vector<std::string_view> seen;
    for (std::size_t i = begin; i < end; ++i)
      if (std::find(seen.begin(), seen.end(), history.verdicts[i]) == seen.end()) {
        seen.emplace_back(history.verdicts[i]);
        kept.push_back(i);
      }
  }
  sortUnique(kept);
  return kept;
}

RunHistory selected(const RunHistory& history, const std::vector<std::size_t>& rows) {
  RunHistory result;
  result.elements = history.elements;
  result.numbers = history.numbers;
  result.notes = history.notes;
  for (const RunHistory::Column& column : history.columns) {
    result.columns.push_back({column.name, {}});
    for (const std::size_t i : rows) result.columns.back().values.push_back(column.values[i]);
  }
  for (const std::size_t i : rows) {
    result.controlling.push_back(history.controlling[i]);
    result.verdicts.push_back(history.verdicts[i]);
  }
  return result;
}

}  // namespace ringwatch
