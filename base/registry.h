#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace detail {

/// What an entry declares: its `info`, by value or by pointer, or the entry itself.
template <class Entry>
constexpr const auto& declarationOf(const Entry& entry) {
  if constexpr (requires { *entry.info; })
    return *entry.info;
  else if constexpr (requires { entry.info; })
    return entry.info;
  else
    return entry;
}
/// What an entry is found by: key() where it has that, else the name that it declares.
template <class Entry>
constexpr std::string_view keyOf(const Entry& entry) {
  if constexpr (requires { entry.key(); })
    return entry.key();
  else
    return declarationOf(entry).name;
}

}  // namespace detail

/// The entries of a folder and those that a program adds by an explicit call when it starts, before it asks for any:
/// what was returned before holds no longer. What an entry points to must outlive all use.
template <class Entry>
class Registry {
 public:
  using Info = std::remove_cvref_t<decltype(detail::declarationOf(std::declval<const Entry&>()))>;

  /// what: "handler", for messages. own: the entries of the folder.
  template <class Entries>
  Registry(std::string_view what, const Entries& own) : what_(what), entries_(std::begin(own), std::end(own)) {
    listInfos();
  }

  std::span<const Entry> all() const { return entries_; }
  /// What the entries declare, in the same order.
  std::span<const Info> infos() const {
    if constexpr (std::is_same_v<Info, Entry>)
      return entries_;
    else
      return infos_;
  }
  /// nullptr when there is none of that name.
  const Entry* find(std::string_view name) const {
    const auto found = std::ranges::find(entries_, name, detail::keyOf<Entry>);
    return found == entries_.end() ? nullptr : &*found;
  }
  /// What the entry of that name declares; nullptr when there is none.
  const Info* findInfo(std::string_view name) const {
    const Entry* entry = find(name);
    return entry ? &infos()[entry - entries_.data()] : nullptr;
  }
  /// Throws InputError that lists the names when there is none of that name.
  const Entry& get(std::string_view name) const {
    if (const Entry* entry = find(name)) return *entry;
    throw InputError(joinText(what_, " \"", name, "\": must be one of ", names()));
  }
  std::string names() const {
    std::string all;
    for (const Entry& entry : entries_) all += joinText(all.empty() ? "" : ", ", detail::keyOf(entry));
    return all;
  }
  /// Throws InputError when the name is taken.
  void add(const Entry& entry) {
    if (find(detail::keyOf(entry)) != nullptr)
      throw InputError(joinText(what_, " \"", detail::keyOf(entry), "\": there is one of that name already"));
    entries_.push_back(entry);
    listInfos();
  }

 private:
  void listInfos() {
    if constexpr (!std::is_same_v<Info, Entry>) {
      infos_.clear();
      for (const Entry& entry : entries_) infos_.push_back(detail::declarationOf(entry));
    }
  }

  std::string_view what_;
  std::vector<Entry> entries_;
  std::vector<Info> infos_;  // empty where an entry is its own
};

}  // namespace ringwatch
