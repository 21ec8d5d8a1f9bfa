#include <ringwatch/materials/registry.h>

#include <cmath>
#include <vector>

#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/registry.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

template <class... Ls>
std::vector<LawEntry> entriesOf(TypeList<Ls...>) {
  return {LawEntry{lawInfo<Ls>(),
                   [](const Options& parameters, Material& material) { material.law = Ls::of(parameters); }}...};
}

Registry<LawEntry>& registry() {
  static Registry<LawEntry> laws("law", entriesOf(Laws{}));
  return laws;
}

void requireParameters(std::string_view law, std::span<const OptionInfo> table, const Options& parameters) {
  for (const auto& [name, value] : parameters) {
    const std::string fault = optionFault(table, parameters, name);
    if (fault.empty()) continue;
    const OptionInfo* option = findOption(table, name);
    const std::string shown = value.number() ? joinText(*value.number()) : inQuotes(*value.text());
    if (option == nullptr) {
      std::string names;
      for (const OptionInfo& own : table) names += joinText(names.empty() ? "" : ", ", own.name);
      throw InputError(joinText(name, " = ", shown, ": is no parameter of the law \"", law, "\"; it takes ", names));
    }
    throw InputError(joinText(name, " = ", shown, option->unit.empty() ? "" : " ", option->unit, ": ", fault));
  }
}

}  // namespace

LawInfo Material::info() const {
  return outside ? outside->info : std::visit([]<class L>(const L&) { return lawInfo<L>(); }, law);
}
Lame Material::restModuli() const {
  return outside ? outside->rest : std::visit([](const auto& l) { return l.restModuli(); }, law);
}
double Material::restModulus() const {
  return outside ? outside->restModulus : std::visit([](const auto& l) { return restModulusOf(l); }, law);
}
double Material::waveSpeed() const { return std::sqrt(restModulus() / density); }
double Material::energy(const Matrix3<double>& F) const {
  return outside ? outside->energy(outside->law.get(), F) : std::visit([&](const auto& l) { return l.energy(F); }, law);
}
Matrix3<double> Material::stress(const Matrix3<double>& F) const {
  return outside ? outside->stress(outside->law.get(), F) : std::visit([&](const auto& l) { return l.stress(F); }, law);
}

Matrix3<double> Material::stressDifferential(const Matrix3<double>& F, const Matrix3<double>& dF) const {
  return outside ? outside->stressDifferential(outside->law.get(), F, dF)
                 : std::visit([&](const auto& l) { return l.linearize(F)(dF); }, law);
}

std::span<const LawInfo> allLaws() { return registry().infos(); }
const LawInfo* findLaw(std::string_view name) { return registry().findInfo(name); }

const LawInfo& lawNamed(std::string_view name) {
  if (const LawInfo* info = findLaw(name)) return *info;
  std::vector<std::string_view> known;
  for (const LawInfo& info : allLaws()) known.push_back(info.name);
  throw InputError(
      joinText("model = ", inQuotes(name), ": ", didYouMean(name, known), "must be one of ", registry().names()));
}

void detail::registerLaw(const LawEntry& entry) { registry().add(entry); }

Material makeMaterial(std::string_view model, const Options& parameters, double density) {
  const LawInfo& info = lawNamed(model);
  requireParameters(info.name, info.parameters, parameters);
  if (!(density > 0) || !std::isfinite(density))
    throw InputError(joinText("density = ", density, " kg/m3: must be a finite number > 0"));
  Material material{Law{}, density};
  const Options all = completed(info.name, info.parameters, parameters);
  registry().get(info.name).make(all, material);
  return material;
}

Material makeMaterial(std::string_view model, double young, double poisson, double density) {
  const LawInfo& info = lawNamed(model);
  requireParameters(info.name, youngAndPoisson, {{"young", young}, {"poisson", poisson}});
  return makeMaterial(model, info.parametersFor(young, poisson), density);
}

}  // namespace ringwatch
