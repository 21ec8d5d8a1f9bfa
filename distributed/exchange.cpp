#include <ringwatch/distributed/exchange.h>

#include <ringwatch/base/error.h>

namespace ringwatch {

std::string shareText(Ranks& ranks, std::string text, int from) {
  std::size_t length = text.size();
  ranks.share(&length, sizeof length, from);
  text.resize(length);
  ranks.share(text.data(), length, from);
  return text;
}

void throwFirst(Ranks& ranks, std::int64_t order, const std::function<std::string()>& text) {
  const std::int64_t first = ranks.least(order);
  if (first == noFault) return;
  const auto from = static_cast<int>(ranks.least(order == first ? ranks.rank() : ranks.size()));
  throw InputError(shareText(ranks, ranks.rank() == from ? text() : "", from));
}

}  // namespace ringwatch
