#pragma once

// Part of lanes.h: two vectors that compute as one of twice the lanes. Half is a compiler's vector or a pair itself.

namespace npsee::lanes {

template <class Half>
struct Pair {
  Half low, high;
  /// Lanes of eight bytes each.
  auto operator[](int lane) const {
    constexpr int kHalf = static_cast<int>(sizeof(Half) / 8);
    return lane < kHalf ? low[lane] : high[lane - kHalf];
  }
};

#define NPSEE_PAIR_OPERATOR(op)                                                                                                                       \
  template <class Half>                                                                                                                               \
  NPSEE_KERNEL_INLINE auto operator op(const Pair<Half>& a, const Pair<Half>& b)->Pair<decltype(a.low op b.low)> { return {a.low op b.low, a.high op b.high}; } \
  template <class Half, class Scalar>                                                                                                                 \
    requires std::is_arithmetic_v<Scalar>                                                                                                             \
  NPSEE_KERNEL_INLINE auto operator op(const Pair<Half>& a, Scalar b)->Pair<decltype(a.low op b)> { return {a.low op b, a.high op b}; }
NPSEE_PAIR_OPERATOR(+)
NPSEE_PAIR_OPERATOR(-)
NPSEE_PAIR_OPERATOR(*)
NPSEE_PAIR_OPERATOR(/)
NPSEE_PAIR_OPERATOR(<)
NPSEE_PAIR_OPERATOR(<=)
NPSEE_PAIR_OPERATOR(>)
NPSEE_PAIR_OPERATOR(>=)
NPSEE_PAIR_OPERATOR(==)
NPSEE_PAIR_OPERATOR(&)
NPSEE_PAIR_OPERATOR(|)
NPSEE_PAIR_OPERATOR(^)
NPSEE_PAIR_OPERATOR(<<)
#undef NPSEE_PAIR_OPERATOR

#define NPSEE_PAIR_SCALAR_FIRST(op) \
  template <class Half>             \
  NPSEE_KERNEL_INLINE Pair<Half> operator op(double a, const Pair<Half>& b) { return {a op b.low, a op b.high}; }
NPSEE_PAIR_SCALAR_FIRST(+)
NPSEE_PAIR_SCALAR_FIRST(-)
NPSEE_PAIR_SCALAR_FIRST(*)
NPSEE_PAIR_SCALAR_FIRST(/)
#undef NPSEE_PAIR_SCALAR_FIRST

template <class Half>
NPSEE_KERNEL_INLINE Pair<Half> operator-(const Pair<Half>& a) { return {-a.low, -a.high}; }
template <class Half>
NPSEE_KERNEL_INLINE Pair<Half> operator~(const Pair<Half>& a) { return {~a.low, ~a.high}; }
template <class Half, class Other>
NPSEE_KERNEL_INLINE Pair<Half>& operator+=(Pair<Half>& a, const Other& b) { return a = a + b; }

template <class Mask, class Half>
NPSEE_KERNEL_INLINE Pair<Half> select(const Pair<Mask>& mask, const Pair<Half>& yes, const Pair<Half>& no) {
  return {select(mask.low, yes.low, no.low), select(mask.high, yes.high, no.high)};
}
template <class Mask>
NPSEE_KERNEL_INLINE bool any(const Pair<Mask>& mask) { return any(mask.low | mask.high); }
template <class Half>
NPSEE_KERNEL_INLINE Pair<Half> squareRoot(const Pair<Half>& x) { return {squareRoot(x.low), squareRoot(x.high)}; }
template <class Half>
NPSEE_KERNEL_INLINE auto bitsOf(const Pair<Half>& x) { return Pair<decltype(bitsOf(x.low))>{bitsOf(x.low), bitsOf(x.high)}; }
template <class Half>
NPSEE_KERNEL_INLINE auto fromBits(const Pair<Half>& x) { return Pair<decltype(fromBits(x.low))>{fromBits(x.low), fromBits(x.high)}; }
template <class Half>
NPSEE_KERNEL_INLINE void fill(Pair<Half>& to, double value) {
  fill(to.low, value);
  fill(to.high, value);
}

}  // namespace npsee::lanes
