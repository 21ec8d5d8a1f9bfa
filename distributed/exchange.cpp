#include <ringwatch/distributed/exchange.h>

#include <ringwatch/base/error.h>

namespace ringwatch {

void throwFirst(Ranks& ranks, std::int64_t order, const std::function<std::string()>& text) {
  const std::int64_t first = ranks.least(order);
  if (first == noFault) return;
  const auto from = ranks.firstWhere(order == first);
  throw InputError(ranks.shareText(ranks.rank() == from ? text() : "", from));
}

}  // namespace ringwatch
