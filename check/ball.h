#pragma once
#include <arb.h>

/// Ball arithmetic: a number with a bound of its error that every operation keeps (Johansson 2017, Arb). A wrapper of
/// Arb's arb_t, so that formulas read as they are written.
namespace check {

class Ball {
 public:
  Ball(double exact = 0) {  // NOLINT(google-explicit-constructor): doubles are exact
    arb_init(value_);
    arb_set_d(value_, exact);
  }
  Ball(const Ball& other) {
    arb_init(value_);
    arb_set(value_, other.value_);
  }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  /// Bits of a midpoint, for all operations of this program.
  static inline slong precision = 128;

  friend Ball operator+(const Ball& a, const Ball& b) { return of(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return of(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return of(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return of(arb_div, a, b); }
  Ball& operator+=(const Ball& b) {
    arb_add(value_, value_, b.value_, precision);
    return *this;
  }
  /// this += a b, and this -= a b.
  void addProduct(const Ball& a, const Ball& b) { arb_addmul(value_, a.value_, b.value_, precision); }
  void subtractProduct(const Ball& a, const Ball& b) { arb_submul(value_, a.value_, b.value_, precision); }

  /// The number that decimals say.
  static Ball ofDecimals(const char* text) {
    Ball r;
    arb_set_str(r.value_, text, precision);
    return r;
  }

  /// Whether all numbers of the ball are positive, or none is negative.
  bool positive() const { return arb_is_positive(value_) != 0; }
  bool nonnegative() const { return arb_is_nonnegative(value_) != 0; }
  friend Ball root(const Ball& a) { return of(arb_sqrt, a); }
  friend Ball logarithm(const Ball& a) { return of(arb_log, a); }
  /// Its midpoint alone, for guesses.
  Ball middle() const {
    Ball r;
    arb_get_mid_arb(r.value_, value_);
    return r;
  }
  double rounded() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }
  /// The largest size of a number in it.
  Ball size() const {
    Ball r;
    arb_get_abs_ubound_arf(arb_midref(r.value_), value_, precision);
    return r;
  }
  /// The ball and all that lies within `distance` of it.
  Ball widened(const Ball& distance) const {
    Ball r = *this;
    arb_add_error(r.value_, distance.value_);
    return r;
  }

 private:
  template <class Operation, class... Balls>
  static Ball of(Operation operation, const Balls&... a) {
    Ball r;
    operation(r.value_, a.value_..., precision);
    return r;
  }
  arb_t value_;
};

}  // namespace check
