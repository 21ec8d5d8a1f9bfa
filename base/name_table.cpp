#include <ringwatch/base/name_table.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch::detail {

void throwUnknownName(std::string_view what, std::string_view name, std::span<const std::string> known) {
  std::string names;
  for (const std::string& one : known) names += (names.empty() ? "" : ", ") + one;
  throw InputError(joinText(what, ": unknown ", inQuotes(name), "; ", didYouMean(name, known),
                            known.size() > 1 ? "must be one of " : "must be ", names));
}

}  // namespace ringwatch::detail
