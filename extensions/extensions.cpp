#include <ringwatch/extensions/extensions.h>

#include <ringwatch/extensions/fe_pbd/fe_pbd.h>
#include <ringwatch/extensions/modal_filter/modal_filter.h>

namespace ringwatch {

void registerExtensions() {
  registerHandler(handlerEntry<FePbd>());
  registerHandler(handlerEntry<ModalFilter>());
}

}  // namespace ringwatch
