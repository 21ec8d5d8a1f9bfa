#pragma once
#include <string>

#include <ringwatch/base/name_table.h>

namespace ringwatch {

/// Consistent systems of units: what numbers and results are called. No number is converted.
enum class Units { si, mmTonneSecond, mmKilogramMillisecond, cmGramMicrosecond, none };
inline constexpr auto unitSystems = nameTable<Units>({
    {Units::si, "SI", "m, kg, s, N, Pa, J"},
    {Units::mmTonneSecond, "mm-t-s", "mm, t, s, N, MPa, mJ"},
    {Units::mmKilogramMillisecond, "mm-kg-ms", "mm, kg, ms, kN, GPa, J"},
    {Units::cmGramMicrosecond, "cm-g-us", "cm, g, us, Mbar"},
    {Units::none, "none", "no unit is named"},
});

/// How many m, kg and s the units of length, mass and time are.
struct UnitSizes {
  double length, mass, time;
};
UnitSizes sizesOf(Units system);

/// Chooses the system that labelled() names in this process; reading a scene does so.
void useUnits(Units system);
Units usedUnits();

/// A text with the units of a system in place of SI's, behind a number ("3 s") and in parentheses behind a space
/// ("step (s)"). Wall times are in "seconds", which stay.
std::string labelled(const std::string& text, Units system = usedUnits());
/// The same of the names of columns, which end with the unit: "time_s,h_s".
std::string labelledColumns(const std::string& head, Units system = usedUnits());
/// The name of a unit: "ms" for "s"; "" where none is named.
std::string unitNamed(const std::string& si);

}  // namespace ringwatch
