#include <array>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/base/registry.h>
#include <ringwatch/handlers/imex/imex.h>
#include <ringwatch/handlers/local_time_stepping/local_time_stepping.h>
#include <ringwatch/handlers/mass_scaling/mass_scaling.h>

namespace ringwatch {
namespace {

/// Every handler of the library, one line each.
constexpr std::array entries{handlerEntry<LocalTimeStepping>(), handlerEntry<Imex>(), handlerEntry<MassScaling>()};

Registry<HandlerEntry>& registry() {
  static Registry<HandlerEntry> handlers("handler", entries);
  return handlers;
}

}  // namespace

std::span<const HandlerEntry> allHandlers() { return registry().all(); }
void registerHandler(const HandlerEntry& entry) {
  if (entry.info->forGpu)
    throw InputError(
        joinText("handler \"", entry.info->name,
                 "\": has forGpu, but a GPU takes the steps of the library's own handlers alone; leave it out"));
  registry().add(entry);
}

const HandlerInfo* findHandler(std::string_view name) {
  for (const HandlerEntry& entry : allHandlers())
    if (entry.info->name == name || (!entry.info->alias.empty() && entry.info->alias == name)) return entry.info;
  return nullptr;
}

std::unique_ptr<Handler> makeHandler(std::string_view name, Body& body, std::unique_ptr<Integrator> base,
                                     const HandlerOptions& options) {
  const HandlerInfo* info = findHandler(name);
  return registry().get(info ? info->name : name).make(body, std::move(base), options);
}

}  // namespace ringwatch
