#pragma once
#include <span>
#include <string_view>
#include <vector>

#include <ringwatch/base/error.h>

namespace ringwatch {

/// The entries of a folder and those that a program adds by an explicit call when it starts, before it asks for any:
/// what `all` returned before holds no longer. nameOf(entry): its name; it and what the entry points to must outlive
/// all use.
template <class Entry, std::string_view (*nameOf)(const Entry&)>
class Registry {
 public:
  explicit Registry(std::span<const Entry> own) : entries_(own.begin(), own.end()) {}

  std::span<const Entry> all() const { return entries_; }
  /// Throws InputError when the name is taken. what: "handler", for the message.
  void add(std::string_view what, const Entry& entry) {
    for (const Entry& known : entries_)
      if (nameOf(known) == nameOf(entry))
        throw InputError(joinText(what, " \"", nameOf(entry), "\": there is one of that name already"));
    entries_.push_back(entry);
  }

 private:
  std::vector<Entry> entries_;
};

}  // namespace ringwatch
