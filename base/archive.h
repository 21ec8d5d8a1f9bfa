#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <ringwatch/base/error.h>

/// Objects as bytes and back, bit by bit: for a program that goes on where another process of the same build stopped. A
/// class takes part by one member template for both directions,
///     void archive(Archive& a) { a(first_, second_); }
/// that names what a constructor does not give it. Of types without it numbers, vectors, arrays, optionals, texts,
/// Eigen's matrices and structs of such members are known. No padding is written, so that equal objects give equal
/// bytes.
namespace ringwatch {
namespace detail {

template <class T, class Archive>
concept Archivable = requires(T& value, Archive& a) {
  value.archive(a);
};
template <class T>
struct IsVector : std::false_type {};
template <class T, class A>
struct IsVector<std::vector<T, A>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
concept EigenMatrix = std::is_base_of_v<Eigen::PlainObjectBase<T>, T>;
template <class T>
struct IsArray : std::is_array<T> {};
template <class T, std::size_t n>
struct IsArray<std::array<T, n>> : std::true_type {};
/// Its bytes are its value and nothing else: no padding and no address.
template <class T>
inline constexpr bool isBytes = std::is_arithmetic_v<T> ||
                                (std::is_trivially_copyable_v<T> && std::has_unique_object_representations_v<T> &&
                                 !std::is_pointer_v<T> && !std::is_same_v<T, std::string_view>);

struct Anything {
  template <class T>
  operator T() const;
};
/// The number of members of a struct: of values of any type that initialise it.
template <class T, class... Some>
constexpr std::size_t memberCount() {
  if constexpr (requires { T{Some{}..., Anything{}}; })
    return memberCount<T, Some..., Anything>();
  else
    return sizeof...(Some);
}
/// Calls visit with all members of a struct.
template <class T, class Visit>
void withMembers(T& value, const Visit& visit) {
  constexpr std::size_t members = memberCount<T>();
  static_assert(members > 0 && members <= 12, "give the class a member archive()");
  // clang-format off
  if constexpr (members == 1) { auto& [a] = value; visit(a); }
  if constexpr (members == 2) { auto& [a, b] = value; visit(a, b); }
  if constexpr (members == 3) { auto& [a, b, c] = value; visit(a, b, c); }
  if constexpr (members == 4) { auto& [a, b, c, d] = value; visit(a, b, c, d); }
  if constexpr (members == 5) { auto& [a, b, c, d, e] = value; visit(a, b, c, d, e); }
  if constexpr (members == 6) { auto& [a, b, c, d, e, f] = value; visit(a, b, c, d, e, f); }
  if constexpr (members == 7) { auto& [a, b, c, d, e, f, g] = value; visit(a, b, c, d, e, f, g); }
  if constexpr (members == 8) { auto& [a, b, c, d, e, f, g, h] = value; visit(a, b, c, d, e, f, g, h); }
  if constexpr (members == 9) { auto& [a, b, c, d, e, f, g, h, i] = value; visit(a, b, c, d, e, f, g, h, i); }
  if constexpr (members == 10) { auto& [a, b, c, d, e, f, g, h, i, j] = value; visit(a, b, c, d, e, f, g, h, i, j); }
  if constexpr (members == 11) { auto& [a, b, c, d, e, f, g, h, i, j, k] = value; visit(a, b, c, d, e, f, g, h, i, j, k); }
  if constexpr (members == 12) { auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value; visit(a, b, c, d, e, f, g, h, i, j, k, l); }
  // clang-format on
}

/// What both directions share: Self has bytes(void*, size).
template <class Self>
class ArchiveBase {
 public:
  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }

 private:
  Self& self() { return static_cast<Self&>(*this); }

  template <class T>
  void one(T& value) {
    if constexpr (Archivable<T, Self>) {
      value.archive(self());
    } else if constexpr (IsVector<T>::value) {
      vector(value);
    } else if constexpr (IsOptional<T>::value) {
      bool has = value.has_value();
      one(has);
      if constexpr (Self::loads) {
        if (has)
          value = typename T::value_type{};
        else
          value.reset();
      }
      if (has) one(*value);
    } else if constexpr (EigenMatrix<T>) {
      matrix(value);
    } else if constexpr (std::is_same_v<T, bool>) {
      char byte = value;
      self().bytes(&byte, sizeof byte);
      if constexpr (Self::loads) value = byte != 0;
    } else if constexpr (isBytes<T>) {
      self().bytes(&value, sizeof value);
    } else if constexpr (IsArray<T>::value) {
      for (auto& element : value) one(element);
    } else if constexpr (std::is_same_v<T, Eigen::Quaternionf>) {
      self().bytes(value.coeffs().data(), 4 * sizeof(float));
    } else if constexpr (std::is_same_v<T, std::string>) {
      value.resize(self().count(value.size(), 1));
      self().bytes(value.data(), value.size());
    } else if constexpr (std::is_same_v<T, std::string_view>) {
      std::string text(value);
      one(text);
      if constexpr (Self::loads) value = kept(std::move(text));
    } else {
      static_assert(std::is_aggregate_v<T>, "give the class a member archive()");
      withMembers(value, [this](auto&... members) { (*this)(members...); });
    }
  }

  template <class T, class A>
  void vector(std::vector<T, A>& values) {
    constexpr bool whole = isBytes<T> && !Archivable<T, Self> && !std::is_same_v<T, bool>;
    values.resize(self().count(values.size(), whole ? sizeof(T) : 1));
    if constexpr (whole) {
      if (!values.empty()) self().bytes(values.data(), values.size() * sizeof(T));
    } else if constexpr (std::is_same_v<T, bool>) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        bool value = values[i];
        one(value);
        values[i] = value;
      }
    } else {
      for (T& value : values) one(value);
    }
  }

  template <class T>
  void matrix(T& values) {
    static_assert(isBytes<typename T::Scalar>);
    if constexpr (T::SizeAtCompileTime == Eigen::Dynamic) {
      std::int64_t rows = values.rows(), columns = values.cols();
      (*this)(rows, columns);
      if constexpr (Self::loads) {
        self().template requireMatrix<T>(rows, columns);
        values = T(rows, columns);  // resize() leaves no object where memory ends
      }
    }
    if (values.size() > 0)
      self().bytes(values.data(), static_cast<std::size_t>(values.size()) * sizeof(typename T::Scalar));
  }

  /// Names in results are views of texts that live as long as the program.
  static std::string_view kept(std::string text) {
    static std::set<std::string> all;
    static std::mutex alone;
    const std::lock_guard guard(alone);
    return *all.insert(std::move(text)).first;
  }
};

}  // namespace detail

/// Appends objects to a text.
class SavingArchive : public detail::ArchiveBase<SavingArchive> {
 public:
  static constexpr bool loads = false;
  void bytes(const void* data, std::size_t size) { text_.append(static_cast<const char*>(data), size); }
  std::size_t count(std::size_t own, std::size_t /*sizeOfEach*/) {
    bytes(&own, sizeof own);
    return own;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// Reads objects from what a SavingArchive gave, in the same order. Throws InputError where the bytes end early.
class LoadingArchive : public detail::ArchiveBase<LoadingArchive> {
 public:
  static constexpr bool loads = true;
  explicit LoadingArchive(std::string_view text) : left_(text) {}
  void bytes(void* data, std::size_t size) {
    if (size > left_.size()) throw InputError("saved state: ends early");
    std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }
  std::size_t count(std::size_t /*own*/, std::size_t sizeOfEach) {
    std::size_t value = 0;
    bytes(&value, sizeof value);
    if (value > left_.size() / sizeOfEach) throw InputError("saved state: ends early");
    return value;
  }
  /// Throws InputError for sizes that no matrix of this type has, or that are more than the bytes that are left.
  template <class T>
  void requireMatrix(std::int64_t rows, std::int64_t columns) const {
    const auto fits = [](std::int64_t size, int fixed) { return fixed == Eigen::Dynamic ? size >= 0 : size == fixed; };
    if (!fits(rows, T::RowsAtCompileTime) || !fits(columns, T::ColsAtCompileTime) ||
        (rows > 0 && columns > static_cast<std::int64_t>(left_.size() / sizeof(typename T::Scalar)) / rows))
      throw InputError("saved state: no matrix in it has such a size");
  }
  /// Throws InputError unless all bytes were read.
  void end() const {
    if (!left_.empty()) throw InputError("saved state: is longer than what it is of");
  }

 private:
  std::string_view left_;
};

/// The version of an object at some time, of which only the difference to that of now has a meaning elsewhere.
template <class Archive>
void archiveVersion(Archive& a, std::int64_t& version, std::int64_t now) {
  std::int64_t since = now - version;
  a(since);
  if constexpr (Archive::loads) version = now - since;
}

/// An object that may be there. Where it is read and was not there it is made of the parameters first.
template <class Archive, class T, class... Parameters>
void archiveOptional(Archive& a, std::optional<T>& object, const Parameters&... parameters) {
  bool isThere = object.has_value();
  a(isThere);
  if (!isThere) object.reset();
  if (isThere && !object) object.emplace(parameters...);
  if (isThere) a(*object);
}

}  // namespace ringwatch
