#pragma once
#include <cstdint>
#include <initializer_list>

namespace ringwatch {

/// Parts of a scene that something else does not go with; capabilities.cpp says what and why.
enum class Feature {
  handler,
  timed,
  pressure,
  discrete,
  surfaces,
  movingObstacles,
  dashpots,
  friction,
  elementDamping,
  rayleigh,
  stiffnessDamping,
  provenDamping,
  rigid,
  cuts,
  erosion,
  uniformStrain,
  otherLaws,
  nodalMass,
  certificates,
  mustCertify,
  gaps,
  savedStates,
  repeat,
  reduceStep,
  hold,
  checkpoints,
  exactTimes,
  probes,
  reactions,
  metric,
  noBracket,
  budget,
  fields,
  handlerAuto,
  handlerSolver,
  handlerDamping,
  handlerHandle,
  handlerHalves,
  handlerDevices
};

/// Some entries of an enumeration of at most 64.
template <class Entry>
class SetOf {
 public:
  constexpr SetOf() = default;
  constexpr SetOf(std::initializer_list<Entry> entries) {
    for (const Entry entry : entries) add(entry);
  }
  constexpr bool has(Entry entry) const { return (bits_ & bit(entry)) != 0; }
  constexpr void add(Entry entry) { bits_ |= bit(entry); }
  friend constexpr SetOf operator|(SetOf set, Entry entry) {
    set.add(entry);
    return set;
  }

 private:
  static constexpr std::uint64_t bit(Entry entry) { return std::uint64_t{1} << static_cast<unsigned>(entry); }
  std::uint64_t bits_ = 0;
};
using Features = SetOf<Feature>;

}  // namespace ringwatch
