#include "jamscape/observe/bond_lanes.hpp"

// All up to #if HWY_ONCE is compiled again for each of Highway's targets; those left out have no wider registers.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "jamscape/observe/bond_lanes.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace jam::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, bond_lanes>;
using Lanes = hn::Vec<Tag>;

struct Phase {  // exp(6 i theta): the same for both ends of a bond, whose directions are opposite
  Lanes re, im;
};
struct Bond {
  Lanes order;  // increases with the angle in [-pi, pi)
  Phase six;
};

HWY_INLINE Bond bond(Lanes x, Lanes y) {
  const Tag d;
  const Lanes zero = hn::Zero(d), two = hn::Set(d, 2.0), upper = hn::Sub(hn::Set(d, 1.0), x);
  const auto is_lower = hn::Or(hn::Lt(y, zero), hn::And(hn::Eq(y, zero), hn::Lt(x, zero)));
  const Lanes re2 = hn::Sub(hn::Mul(x, x), hn::Mul(y, y)), im2 = hn::Mul(hn::Mul(two, x), y);
  const Lanes re3 = hn::Sub(hn::Mul(re2, x), hn::Mul(im2, y)), im3 = hn::Add(hn::Mul(re2, y), hn::Mul(im2, x));
  return {hn::IfThenElse(is_lower, hn::Neg(upper), upper),
          {hn::Sub(hn::Mul(re3, re3), hn::Mul(im3, im3)), hn::Mul(hn::Mul(two, re3), im3)}};
}

HWY_INLINE Phase load_phase(const LaneBonds& from, std::size_t lane) {
  return {hn::Load(Tag(), from.re + lane), hn::Load(Tag(), from.im + lane)};
}

HWY_INLINE void store(const Bond& b, LaneBonds& to, std::size_t lane) {
  hn::Store(b.order, Tag(), to.order + lane);
  hn::Store(b.six.re, Tag(), to.re + lane);
  hn::Store(b.six.im, Tag(), to.im + lane);
}

/// Among k sorted bonds; those at one angle stay in the order in which they come.
HWY_INLINE void insert(Bond b, std::size_t k, LaneBonds* sorted, std::size_t lane) {
  for (; k > 0; --k) {  // the later one of b and the bond before it moves up
    const Lanes order = hn::Load(Tag(), sorted[k - 1].order + lane);
    const Phase six = load_phase(sorted[k - 1], lane);
    const auto before = hn::Lt(b.order, order);
    const auto choose = [&](Lanes x, Lanes y) HWY_ATTR { return hn::IfThenElse(before, x, y); };
    store({hn::Max(b.order, order), {choose(six.re, b.six.re), choose(six.im, b.six.im)}}, sorted[k], lane);
    b = {hn::Min(b.order, order), {choose(b.six.re, six.re), choose(b.six.im, six.im)}};
  }
  store(b, sorted[0], lane);
}

HWY_INLINE Lanes cos_of_gap(const Phase& a, const Phase& b) {
  return hn::Add(hn::Mul(a.re, b.re), hn::Mul(a.im, b.im));
}

}  // namespace

void order_blocks(std::size_t bonds, std::size_t blocks, const LaneDirections* directions, LaneBonds* sorted,
                  LaneOrders* orders) {
  const Tag d;
  const Lanes n = hn::Set(d, static_cast<double>(bonds)), inner = hn::Set(d, static_cast<double>(bonds) - 1);
  for (std::size_t b = 0; b < blocks; ++b, directions += bonds)
    for (std::size_t lane = 0; lane < bond_lanes; lane += hn::Lanes(d)) {
      for (std::size_t k = 0; k < bonds; ++k)
        insert(bond(hn::Load(d, directions[k].x + lane), hn::Load(d, directions[k].y + lane)), k, sorted, lane);
      const Phase first = load_phase(sorted[0], lane);
      Phase last = first, sum = first;
      Lanes gaps = hn::Zero(d);
      for (std::size_t k = 1; k < bonds; ++k) {
        const Phase next = load_phase(sorted[k], lane);
        gaps = hn::Add(gaps, cos_of_gap(last, next));
        sum = {hn::Add(sum.re, next.re), hn::Add(sum.im, next.im)};
        last = next;
      }
      const Lanes size = hn::Sqrt(hn::Add(hn::Mul(sum.re, sum.re), hn::Mul(sum.im, sum.im)));
      hn::Store(hn::Div(gaps, inner), d, orders[b].printed + lane);
      hn::Store(hn::Div(hn::Add(gaps, cos_of_gap(last, first)), n), d, orders[b].closed + lane);
      hn::Store(hn::Div(size, n), d, orders[b].local + lane);
      hn::Store(hn::Div(sum.re, n), d, orders[b].re + lane);
      hn::Store(hn::Div(sum.im, n), d, orders[b].im + lane);
    }
}

}  // namespace jam::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace jam {

HWY_EXPORT(order_blocks);

void order_blocks(std::size_t bonds, std::size_t blocks, const LaneDirections* directions, LaneBonds* sorted,
                  LaneOrders* orders) {
  HWY_DYNAMIC_DISPATCH(order_blocks)(bonds, blocks, directions, sorted, orders);
}

}  // namespace jam
#endif
