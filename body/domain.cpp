#include <ringwatch/body/domain.h>

namespace ringwatch {

Domain& wholeDomain() {
  static Domain whole;
  return whole;
}

}  // namespace ringwatch
