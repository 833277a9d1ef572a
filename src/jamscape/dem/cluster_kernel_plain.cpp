// One pair after another: the reference.
#include "jamscape/dem/cluster_contact.hpp"
#include "jamscape/dem/cluster_kernel.hpp"
#include "jamscape/dem/cluster_motion.hpp"

namespace jam {
namespace {

void collect(const ClusterState& b, const ArmPairs& p, ArmContacts& out) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < p.size(); k += block) {
    std::uint8_t bits = 0;
    for (std::size_t l = 0; l < block; ++l) {
      const double *one = b.arm(p.arm_i[k + l]), *two = b.arm(p.arm_j[k + l]);
      const double reach = one[3] + two[3];
      const ClosestPoints<double> c = closest_points(axis_of(one), axis_of(two));
      if (!(c.distance2 < reach * reach)) continue;
      bits = static_cast<std::uint8_t>(bits | 1u << l);
      out.pair[count] = static_cast<std::uint32_t>(k + l);
      out.s[count] = c.s;
      out.t[count] = c.t;
      ++count;
    }
    out.touching[k / block] = bits;
  }
  out.count = count;
}

template <NormalLaw law, bool friction, ParallelRule parallel>
void press_loop(ClusterState& b, ArmPairs& p, const ArmContacts& contacts, const PressRule& rule, ClusterTally& tally) {
  using R = ClusterRow;
  for (std::size_t c = 0; c < contacts.count; ++c) {
    const std::size_t k = contacts.pair[c], slot = c % block;
    const double *one = b.arm(p.arm_i[k]), *two = b.arm(p.arm_j[k]), *bi = b.row(p.i[k]), *bj = b.row(p.j[k]);
    const ArmTouch<double> touched = touch_arms<parallel>(axis_of(one), one[3], axis_of(two), two[3], contacts.s[c],
                                                          contacts.t[c], rule.parallel_sine2);
    const Vec3 lever_i = touched.point - vec3(bi), lever_j = touched.point - vec3(bj);
    const Vec3 v = (vec3(bi + R::velocity) + cross(vec3(bi + R::spin), lever_i)) -
                   (vec3(bj + R::velocity) + cross(vec3(bj + R::spin), lever_j));
    Vec3 spring = p.spring(k);
    const auto f =
        touch<3, law, friction>(rule.law, touched.normal, touched.overlap, p.mbar[k], v, Vec3{}, spring, rule.dt);
    tally.damped[slot] += f.damped;
    tally.rubbed[slot] += f.rubbed;
    tally.excess[slot] = larger(tally.excess[slot], touched.overlap - smaller(one[3], two[3]));
    const Vec3 force = (-f.normal) * touched.normal + f.tangential;
    const Vec3 torque_i = cross(lever_i, force), torque_j = cross(lever_j, force);
    double *fi = b.force(p.i[k]), *fj = b.force(p.j[k]);
    for (int e = 0; e < 3; ++e) {
      fi[e] += force[e], fi[4 + e] += torque_i[e];
      fj[e] -= force[e], fj[4 + e] -= torque_j[e];
      if constexpr (friction) p.springs[4 * k + static_cast<std::size_t>(e)] = spring[e];
    }
  }
}

template <NormalLaw law, bool friction>
void press_law(ClusterState& b, ArmPairs& p, const ArmContacts& c, const PressRule& rule, ClusterTally& tally) {
  rule.parallel == ParallelRule::middle ? press_loop<law, friction, ParallelRule::middle>(b, p, c, rule, tally)
                                        : press_loop<law, friction, ParallelRule::blend>(b, p, c, rule, tally);
}

void press(ClusterState& b, ArmPairs& p, const ArmContacts& c, const PressRule& rule, ClusterTally& tally) {
  with_law(rule.kind, [&]<NormalLaw law>() {
    rule.law.mu > 0 ? press_law<law, true>(b, p, c, rule, tally) : press_law<law, false>(b, p, c, rule, tally);
  });
}

}  // namespace

const ClusterKernels& plain_cluster_kernels() {
  static const ClusterKernels kernels{"plain", collect, press, integrate};
  return kernels;
}

}  // namespace jam
