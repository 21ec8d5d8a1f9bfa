#pragma once
#include <ringwatch/base/name_table.h>
#include <ringwatch/monitor/element_cause.h>

namespace ringwatch {

/// How an element departs from rest most, from 5 % on.
enum class ElementStrain { none, stretched, compressed, inverted, notFinite };
inline constexpr auto elementStrainNames = nameTable<ElementStrain>({
    {ElementStrain::none, "unstrained"},
    {ElementStrain::stretched, "stretched"},
    {ElementStrain::compressed, "compressed"},
    {ElementStrain::inverted, "inverted"},
    {ElementStrain::notFinite, "not finite"},
});

ElementStrain strainOf(const ElementCause& cause);

}  // namespace ringwatch
