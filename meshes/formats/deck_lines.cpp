#include <ringwatch/meshes/formats/deck_lines.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include <ringwatch/base/machine_memory.h>

namespace ringwatch::detail {
namespace {

constexpr std::size_t deepestInclude = 20, mostIncludes = 10'000;

std::string_view trimmedLine(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Skips a line from `at` and returns it, trimmed.
std::string_view takeLine(std::string_view text, std::size_t& at) {
  const std::size_t begin = at, end = std::min(text.find('\n', begin), text.size());
  at = end + 1;
  return trimmedLine(text.substr(begin, end - begin));
}

bool isNoLine(std::string_view line) { return line.empty() || line.starts_with("**"); }

/// The name of a keyword: upper case, one blank between two words.
std::string keywordName(std::string_view written) {
  std::string name;
  for (const char c : inUpperCase(trimmedLine(written))) {
    const bool blank = c == ' ' || c == '\t';
    if (blank && (name.empty() || name.back() == ' ')) continue;
    name += blank ? ' ' : c;
  }
  return name;
}

}  // namespace

bool startsWithDeck(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view line = takeLine(text, at);
    if (isNoLine(line)) continue;
    return line.size() > 1 && line[0] == '*' &&
           ((line[1] >= 'A' && line[1] <= 'Z') || (line[1] >= 'a' && line[1] <= 'z'));
  }
  return false;
}

DeckLines::DeckLines(const std::filesystem::path& path, const std::string& text) : folder_(path.parent_path()) {
  open(path, &text);
}

void DeckLines::open(const std::filesystem::path& path, const std::string* text) {
  std::error_code error;
  std::filesystem::path canonical = std::filesystem::canonical(path, error);
  if (error) canonical = path;
  if (text == nullptr) {
    std::unique_ptr<std::string>& known = texts_[canonical];
    if (!known) known = std::make_unique<std::string>(readWholeFile(path));
    text = known.get();
  }
  refuseForeign(path, *text);
  sources_.push_back({path, canonical, text, bytes_, std::make_unique<FileCursor>(*text, path.string())});
  bytes_ += text->size() + 1;  // so that the end of a file has a position of its own
  open_.push_back({sources_.size() - 1, 0});
}

std::string DeckLines::where(std::size_t position) const {
  const auto after = std::upper_bound(sources_.begin(), sources_.end(), position,
                                      [](std::size_t at, const Source& source) { return at < source.base; });
  const Source& source = *std::prev(after);
  return source.cursor->where(position - source.base);
}

std::optional<DeckLine> DeckLines::nextOfFiles() {
  while (!open_.empty()) {
    Open& file = open_.back();
    const Source& source = sources_[file.source];
    while (file.at < source.text->size()) {
      const std::size_t begin = file.at;
      const std::string_view line = takeLine(*source.text, file.at);
      if (!isNoLine(line)) return DeckLine{line, source.base + begin, file.at <= source.text->size()};
    }
    open_.pop_back();
  }
  return std::nullopt;
}

std::optional<DeckLine> DeckLines::next() {
  while (const std::optional<DeckLine> line = nextOfFiles()) {
    if (!line->isKeyword() || keywordName(fields(line->text).front().substr(1)) != "INCLUDE") return line;
    include(keyword(*line));
  }
  return std::nullopt;
}

void DeckLines::include(const DeckKeyword& keyword) {
  const auto refuse = [&](const std::string& what) { failAt(keyword.position, "*" + keyword.name + " " + what); };
  const std::string name = keyword.value("INPUT");
  if (name.empty()) refuse("needs the name of a file, INPUT=");
  std::filesystem::path path = folder_ / name;  // an absolute name stays as it is
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    const auto after = std::upper_bound(sources_.begin(), sources_.end(), keyword.position,
                                        [](std::size_t at, const Source& source) { return at < source.base; });
    const std::filesystem::path beside = std::prev(after)->path.parent_path() / name;
    if (std::filesystem::exists(beside, error)) path = beside;
  }
  const std::filesystem::path canonical = std::filesystem::canonical(path, error);
  for (const Open& file : open_)
    if (!error && sources_[file.source].canonical == canonical)
      refuse(joinText("takes in ", path.string(), ", which is being read; a file must not include itself"));
  if (open_.size() > deepestInclude)
    refuse(joinText("lies ", open_.size(), " files deep; at most ", deepestInclude, " are followed"));
  if (sources_.size() > mostIncludes)
    refuse(joinText("is number ", sources_.size(), "; at most ", mostIncludes, " are followed"));
  try {
    open(path, nullptr);
  } catch (const InputError& fault) {
    refuse(joinText("takes in ", fault.what()));
  }
  if (bytes_ > machineMemory())
    refuse(joinText("makes the deck longer than the memory of this machine, ", machineMemory(), " bytes"));
}

DeckKeyword DeckLines::keyword(const DeckLine& first) {
  std::string whole(first.text);
  while (!whole.empty() && whole.back() == ',') {
    const std::optional<DeckLine> more = nextOfFiles();
    if (!more || more->isKeyword())
      failAt(first.position, "the keyword line ends with a comma, but no line continues it");
    whole += std::string(more->text);
  }
  DeckKeyword keyword;
  keyword.position = first.position;
  bool isName = true;
  for (const std::string_view field : fields(whole)) {
    if (isName) {
      keyword.name = keywordName(field.substr(1));
    } else {
      const std::size_t equals = field.find('=');
      std::string_view value =
          equals == std::string_view::npos ? std::string_view() : trimmedLine(field.substr(equals + 1));
      if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
      keyword.parameters[inUpperCase(trimmedLine(field.substr(0, equals)))] = std::string(value);
    }
    isName = false;
  }
  return keyword;
}

std::vector<std::string_view> DeckLines::fields(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    result.push_back(trimmedLine(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  if (result.size() > 1 && result.back().empty()) result.pop_back();  // the line ends with a comma
  return result;
}

std::int64_t DeckLines::number(std::string_view word, std::string_view what, std::size_t position) const {
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size() || value < 1)
    failAt(position, joinText(what, " is ", detail::quoted(word), "; it must be a whole number of 1 or more"));
  return value;
}

double DeckLines::real(std::string_view word, std::string_view what, std::size_t position) const {
  std::string copy(word);
  if (!copy.empty() && copy.front() == '+') copy.erase(0, 1);
  for (char& c : copy)
    if (c == 'd' || c == 'D') c = 'e';  // Fortran's double precision
  double value = 0;
  const auto [stop, error] = std::from_chars(copy.data(), copy.data() + copy.size(), value);
  if (error != std::errc() || stop != copy.data() + copy.size() || !std::isfinite(value))
    failAt(position, joinText(what, " is ", detail::quoted(word), "; it must be a number"));
  return value;
}

}  // namespace ringwatch::detail
