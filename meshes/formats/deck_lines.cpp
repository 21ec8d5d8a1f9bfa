#include <ringwatch/meshes/formats/deck_lines.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include <ringwatch/base/machine_memory.h>
#include <ringwatch/base/number_format.h>

namespace ringwatch::detail {
namespace {

constexpr std::size_t deepestInclude = 20, mostIncludes = 10'000;

std::string_view trimmedLine(std::string_view text) {
  constexpr char endOfDos = '\x1A';
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == endOfDos; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// A name in quotes, which may hold blanks.
std::string_view unquoted(std::string_view text) {
  const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

/// Skips a line from `at` and returns it.
std::string_view nextLine(std::string_view text, std::size_t& at) {
  const std::size_t begin = at, end = std::min(text.find('\n', begin), text.size());
  at = end + 1;
  return text.substr(begin, end - begin);
}

/// The first line of a text that is neither empty nor begins with a comment's sign.
std::string_view firstLine(std::string_view text, std::string_view comment) {
  for (std::size_t at = 0; at < text.size();)
    if (const std::string_view line = trimmedLine(nextLine(text, at)); !line.empty() && !line.starts_with(comment))
      return line;
  return {};
}

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

bool isKeywordLine(std::string_view line) {
  return line.size() > 1 && line[0] == '*' &&
         ((line[1] >= 'A' && line[1] <= 'Z') || (line[1] >= 'a' && line[1] <= 'z'));
}

}  // namespace

std::optional<double> fortranNumber(std::string_view word) {
  std::string text;
  for (const char c : word) {
    const bool sign = c == '+' || c == '-';
    if (sign && !text.empty() && text.back() != 'e') text += 'e';
    if (c == '+') continue;
    text += c == 'd' || c == 'D' || c == 'E' ? 'e' : c;
  }
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (stop != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    value = *readNumber(text);  // 0 or infinite, which from_chars does not tell apart
  else if (error != std::errc())
    return std::nullopt;
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

bool startsWithDeck(std::string_view text) { return isKeywordLine(firstLine(text, "**")); }

bool startsWithDyna(std::string_view text) {
  const std::string_view first = firstLine(text, "$");
  if (!isKeywordLine(first)) return false;
  return firstLine(text, "**").starts_with("$") || inUpperCase(first).starts_with("*KEYWORD");
}

DeckLines::DeckLines(const std::filesystem::path& path, const std::string& text, DeckDialect dialect)
    : dialect_(dialect), folder_(path.parent_path()) {
  open(path, &text);
}

bool DeckLines::isNoLine(std::string_view line) const {
  return dialect_ == DeckDialect::dyna ? line.starts_with("$") : line.empty() || line.starts_with("**");
}

std::string_view DeckLines::takeLine(std::string_view text, std::size_t& at) const {
  const std::string_view line = nextLine(text, at), trimmed = trimmedLine(line);
  if (dialect_ == DeckDialect::abaqus) return trimmed;
  return trimmed.empty() ? trimmed : line.substr(0, static_cast<std::size_t>(trimmed.end() - line.begin()));
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
  if (dialect_ == DeckDialect::dyna) return nextOfDyna();
  while (const std::optional<DeckLine> line = nextOfFiles()) {
    if (!line->isKeyword() || keywordName(fields(line->text).front().substr(1)) != "INCLUDE") return line;
    include(keyword(*line));
  }
  return std::nullopt;
}

std::optional<DeckLine> DeckLines::nextOfDyna() {
  while (const std::optional<DeckLine> line = nextOfFiles()) {
    Open& file = open_.back();
    if (line->isKeyword()) {
      const std::string name = inUpperCase(line->text.substr(1, line->text.find_first_of(" \t,") - 1));
      if (file.included == 0u || !file.name.empty())
        failAt(line->position, "*INCLUDE above has no name of a file, or one that does not end");
      file.included = name == "INCLUDE" ? std::optional<std::size_t>(0) : std::nullopt;
      if (name == "END")
        open_.pop_back();
      else if (!file.included)
        return line;
    } else if (!file.included) {
      return line;
    } else if (!line->text.empty()) {
      file.name += trimmedLine(line->text);
      if (file.name.ends_with(" +")) {  // goes on in the next line
        file.name.resize(file.name.size() - 2);
        continue;
      }
      ++*file.included;
      include(std::exchange(file.name, {}), "INCLUDE", line->position);
    }
  }
  return std::nullopt;
}

void DeckLines::include(const DeckKeyword& keyword) {
  const std::string name = keyword.value("INPUT");
  if (name.empty()) failAt(keyword.position, "*" + keyword.name + " needs the name of a file, INPUT=");
  include(name, keyword.name, keyword.position);
}

void DeckLines::include(std::string name, std::string_view keyword, std::size_t position) {
  std::ranges::replace(name, '\\', '/');  // of decks that Windows wrote
  const auto refuse = [&](const std::string& what) { failAt(position, joinText("*", keyword, " ", what)); };
  std::filesystem::path path = folder_ / name;  // an absolute name stays as it is
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    const auto after = std::upper_bound(sources_.begin(), sources_.end(), position,
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
      const std::string_view value =
          equals == std::string_view::npos ? std::string_view() : unquoted(trimmedLine(field.substr(equals + 1)));
      std::string key = inUpperCase(trimmedLine(field.substr(0, equals)));
      std::erase(key, ' ');  // REF NODE is REFNODE
      const auto [known, isNew] = keyword.parameters.try_emplace(key, value);
      if (!isNew && known->second != value)
        failAt(first.position, joinText("*", keyword.name, " has ", key, " twice, ", detail::quoted(known->second),
                                        " and ", detail::quoted(value), "; leave one out"));
    }
    isName = false;
  }
  return keyword;
}

std::vector<std::string_view> DeckLines::fields(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    result.push_back(unquoted(trimmedLine(line.substr(begin, end - begin))));
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
  const std::optional<double> value = fortranNumber(word);
  if (!value) failAt(position, joinText(what, " is ", detail::quoted(word), "; it must be a number"));
  return *value;
}

}  // namespace ringwatch::detail
