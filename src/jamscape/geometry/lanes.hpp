// Several doubles side by side, computed with at once: the scalar type of the vectorised kernels (Highway underneath).
// Only for files compiled for one vector width (kernel_avx2.cpp, kernel_avx512.cpp); each width has its own namespace.
// Element-wise, correctly rounded operations alone, hence the same bits as the same formula in double.
#pragma once

#include <hwy/highway.h>

#include "jamscape/geometry/scalar.hpp"

namespace jam::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, 8>;
using Tag4 = hn::FixedTag<double, 4>;

/// Bit l is lane l: of a mask for vectors of any type, and back.
template <class D, class M>
JAM_INLINE std::uint32_t bits_of_lanes(D d, M mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, mask, bits);
  return bits[0];
}
template <class D>
JAM_INLINE hn::Mask<D> lanes_of_bits(D d, std::uint32_t bits) {
  const std::uint8_t padded[8] = {static_cast<std::uint8_t>(bits)};
  return hn::LoadMaskBits(d, padded);
}

struct Mask {
  hn::Mask<Tag> m;
};
JAM_INLINE bool none(Mask a) { return hn::AllFalse(Tag(), a.m); }
JAM_INLINE bool any(Mask a) { return !none(a); }
/// The lanes below n.
JAM_INLINE Mask first_lanes(int n) { return {hn::FirstN(Tag(), static_cast<std::size_t>(n))}; }
JAM_INLINE Mask lanes_of(std::uint8_t bits) { return {lanes_of_bits(Tag(), bits)}; }
JAM_INLINE std::uint32_t lane_bits(Mask a) { return bits_of_lanes(Tag(), a.m); }

struct Lanes {
  hn::Vec<Tag> v;

  static constexpr int width = HWY_MAX_BYTES / 8;

  Lanes() = default;
  JAM_INLINE Lanes(hn::Vec<Tag> raw) : v(raw) {}
  JAM_INLINE Lanes(double a) : v(hn::Set(Tag(), a)) {}
  JAM_INLINE static Lanes load(const double* p) { return hn::Load(Tag(), p); }
  JAM_INLINE static Lanes load_anywhere(const double* p) { return hn::LoadU(Tag(), p); }
  JAM_INLINE void store(double* p) const { hn::Store(v, Tag(), p); }
};

JAM_INLINE Lanes operator+(Lanes a, Lanes b) { return hn::Add(a.v, b.v); }
JAM_INLINE Lanes operator-(Lanes a, Lanes b) { return hn::Sub(a.v, b.v); }
JAM_INLINE Lanes operator-(Lanes a) { return hn::Neg(a.v); }
JAM_INLINE Lanes operator*(Lanes a, Lanes b) { return hn::Mul(a.v, b.v); }
JAM_INLINE Lanes operator/(Lanes a, Lanes b) { return hn::Div(a.v, b.v); }
JAM_INLINE Mask operator<(Lanes a, Lanes b) { return {hn::Lt(a.v, b.v)}; }
JAM_INLINE Mask operator>(Lanes a, Lanes b) { return {hn::Gt(a.v, b.v)}; }
JAM_INLINE Lanes square_root(Lanes a) { return hn::Sqrt(a.v); }
JAM_INLINE Lanes add_product_once(Lanes c, Lanes a, Lanes b) { return hn::MulAdd(a.v, b.v, c.v); }
JAM_INLINE Lanes subtract_product_once(Lanes c, Lanes a, Lanes b) { return hn::NegMulAdd(a.v, b.v, c.v); }
JAM_INLINE Lanes magnitude(Lanes a) { return hn::Abs(a.v); }
/// One instruction each, which does what a < b ? a : b does, of NaN and of zeros too.
JAM_INLINE Lanes smaller(Lanes a, Lanes b) { return hn::Min(a.v, b.v); }
JAM_INLINE Lanes larger(Lanes a, Lanes b) { return hn::Max(a.v, b.v); }
JAM_INLINE Lanes select(Mask condition, Lanes a, Lanes b) { return hn::IfThenElse(condition.m, a.v, b.v); }
JAM_INLINE Lanes select_or_zero(Mask condition, Lanes a) { return hn::IfThenElseZero(condition.m, a.v); }

/// The lanes of `chosen` side by side from p on; behind them, up to `width` numbers, anything.
JAM_INLINE void store_chosen(Lanes a, Mask chosen, double* p) { hn::CompressStore(a.v, chosen.m, Tag(), p); }

/// Four columns of `width` rows of four doubles.
struct Columns {
  Lanes c[4];
};

/// `width` rows of four doubles: part l holds row l and (for eight lanes) row l + 4 side by side.
template <class T = Tag>
struct TurnedRows {
  hn::Vec<T> part[4];
};
using Turned = TurnedRows<>;
JAM_INLINE Turned operator+(const Turned& a, const Turned& b) {
  return {{hn::Add(a.part[0], b.part[0]), hn::Add(a.part[1], b.part[1]), hn::Add(a.part[2], b.part[2]),
           hn::Add(a.part[3], b.part[3])}};
}
JAM_INLINE Turned operator-(const Turned& a, const Turned& b) {
  return {{hn::Sub(a.part[0], b.part[0]), hn::Sub(a.part[1], b.part[1]), hn::Sub(a.part[2], b.part[2]),
           hn::Sub(a.part[3], b.part[3])}};
}
JAM_INLINE Turned operator-(const Turned& a) {
  return {{hn::Neg(a.part[0]), hn::Neg(a.part[1]), hn::Neg(a.part[2]), hn::Neg(a.part[3])}};
}

/// The rows of all lanes: row(l) points to the one of lane l. Whole rows come with one load each, which beats gathering
/// element by element.
template <class T = Tag, class Row>
JAM_INLINE TurnedRows<T> load_turned(const Row& row) {
  TurnedRows<T> rows;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto lower = hn::Load(Tag4(), row(k));
    if constexpr (hn::MaxLanes(T()) == 8)
      rows.part[k] = hn::Combine(T(), hn::Load(Tag4(), row(k + 4)), lower);
    else
      rows.part[k] = lower;
  }
  return rows;
}
/// The rows base[index[l] * stride ...+3].
template <class T = Tag>
JAM_INLINE TurnedRows<T> load_turned(const double* base, const std::uint32_t* index, std::size_t stride) {
  return load_turned<T>([&](std::size_t l) { return base + index[l] * stride; });
}

/// In each group of four: the first two of a and of b.
template <class V>
JAM_INLINE V first_twos(V a, V b) {
#if HWY_MAX_BYTES == 64
  return V{_mm512_permutex2var_pd(a.raw, _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13), b.raw)};
#else
  return hn::ConcatLowerLower(Tag(), b, a);
#endif
}
/// In each group of four: the last two of a and of b.
template <class V>
JAM_INLINE V last_twos(V a, V b) {
#if HWY_MAX_BYTES == 64
  return V{_mm512_permutex2var_pd(a.raw, _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15), b.raw)};
#else
  return hn::ConcatUpperUpper(Tag(), b, a);
#endif
}

/// Column c holds element c of each row. Columns nobody reads cost nothing.
JAM_INLINE Columns columns(const Turned& x) {
  const Tag d;
  const auto ab02 = hn::InterleaveLower(d, x.part[0], x.part[1]), ab13 = hn::InterleaveUpper(d, x.part[0], x.part[1]);
  const auto ce02 = hn::InterleaveLower(d, x.part[2], x.part[3]), ce13 = hn::InterleaveUpper(d, x.part[2], x.part[3]);
  return {{first_twos(ab02, ce02), first_twos(ab13, ce13), last_twos(ab02, ce02), last_twos(ab13, ce13)}};
}
JAM_INLINE Columns load_rows(const double* base, const std::uint32_t* index, std::size_t stride) {
  return columns(load_turned(base, index, stride));
}

/// The inverse of columns().
JAM_INLINE Turned turned(const Columns& x) {
  const Tag d;
  const auto p_even = hn::InterleaveLower(d, x.c[0].v, x.c[1].v), p_odd = hn::InterleaveUpper(d, x.c[0].v, x.c[1].v);
  const auto q_even = hn::InterleaveLower(d, x.c[2].v, x.c[3].v), q_odd = hn::InterleaveUpper(d, x.c[2].v, x.c[3].v);
  return {{first_twos(p_even, q_even), first_twos(p_odd, q_odd), last_twos(p_even, q_even), last_twos(p_odd, q_odd)}};
}

/// The inverse of load_rows: rows of four doubles, in the order of the lanes.
struct Rows {
  hn::Vec<Tag4> row[8];
};
template <class T = Tag>
JAM_INLINE Rows to_rows(const Columns& x) {
  const T d;
  const TurnedRows<T> r = turned(x);
  Rows out;
  for (int l = 0; l < 4; ++l) {
    if constexpr (hn::MaxLanes(d) == 8) {
      const hn::Half<T> h;
      out.row[l] = hn::LowerHalf(h, r.part[l]);
      out.row[l + 4] = hn::UpperHalf(h, r.part[l]);
    } else {
      out.row[l] = r.part[l];
    }
  }
  return out;
}

JAM_INLINE void add_to(double* p, hn::Vec<Tag4> row) { hn::Store(hn::Add(hn::Load(Tag4(), p), row), Tag4(), p); }

JAM_INLINE void subtract_from(double* p, hn::Vec<Tag4> row) { hn::Store(hn::Sub(hn::Load(Tag4(), p), row), Tag4(), p); }

/// Row l of `a` and, behind it, row l of `b`: for eight lanes.
template <class T>
JAM_INLINE hn::Vec<T> row_of_two(const TurnedRows<T>& a, const TurnedRows<T>& b, std::size_t l) {
  const T d;
  return l < 4 ? hn::ConcatLowerLower(d, b.part[l % 4], a.part[l % 4])
               : hn::ConcatUpperUpper(d, b.part[l % 4], a.part[l % 4]);
}

/// Adds row l of `a` and, behind it, row l of `b`.
template <class T>
JAM_INLINE void add_two_to(double* p, const TurnedRows<T>& a, const TurnedRows<T>& b, std::size_t l) {
  const T d;
  if constexpr (hn::MaxLanes(d) == 8) {
    hn::Store(hn::Add(hn::Load(d, p), row_of_two(a, b, l)), d, p);
  } else {
    add_to(p, a.part[l]);
    add_to(p + 4, b.part[l]);
  }
}
template <class T>
JAM_INLINE void subtract_two_from(double* p, const TurnedRows<T>& a, const TurnedRows<T>& b, std::size_t l) {
  const T d;
  if constexpr (hn::MaxLanes(d) == 8) {
    hn::Store(hn::Sub(hn::Load(d, p), row_of_two(a, b, l)), d, p);
  } else {
    subtract_from(p, a.part[l]);
    subtract_from(p + 4, b.part[l]);
  }
}

}  // namespace jam::HWY_NAMESPACE
