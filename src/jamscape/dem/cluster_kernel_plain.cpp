// One pair after another: the reference.
#include "jamscape/dem/cluster_contact.hpp"
#include "jamscape/dem/cluster_kernel.hpp"
#include "jamscape/dem/cluster_motion.hpp"

namespace jam {
namespace {

using R = ClusterRow;

bool nearer(const double* one, const double* two, double skin) {
  const double reach = one[3] + two[3] + skin;
  return closest_points(axis_of(one), axis_of(two)).distance2 < reach * reach;
}

std::size_t near(const NearArms& p) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < p.count; ++k)
    if (nearer(p.arms + R::arm_stride * p.arm_i[k], p.arms + R::arm_stride * p.arm_j[k], p.skin[k]))
      p.near[count++] = static_cast<std::uint32_t>(k);
  return count;
}

std::size_t collect(const CollectArrays& p) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < p.pairs; k += block) {
    std::uint8_t bits = 0;
    for (std::size_t l = 0; l < block; ++l) {
      if (!nearer(p.arms + R::arm_stride * p.arm_i[k + l], p.arms + R::arm_stride * p.arm_j[k + l], 0)) continue;
      bits = static_cast<std::uint8_t>(bits | 1u << l);
      p.pair[count++] = static_cast<std::uint32_t>(k + l);
    }
    p.touching[k / block] = bits;
  }
  return count;
}

/// Pair k, the c-th that touches.
template <NormalLaw law, bool friction, ParallelRule parallel>
void press_pair(const PressArrays& p, std::size_t k, std::size_t c) {
  const PressRule& rule = *p.rule;
  const std::size_t slot = c % block;
  const double *one = p.arms + R::arm_stride * p.arm_i[k], *two = p.arms + R::arm_stride * p.arm_j[k];
  const double *bi = p.rows + R::stride * p.i[k], *bj = p.rows + R::stride * p.j[k];
  const ArmTouch<double> touched = touch_arms<parallel>(one, two, rule.parallel_sine2);
  const Vec3 lever_i = touched.point - vec3(bi), lever_j = touched.point - vec3(bj);
  const Vec3 v = (vec3(bi + R::velocity) + cross(vec3(bi + R::spin), lever_i)) -
                 (vec3(bj + R::velocity) + cross(vec3(bj + R::spin), lever_j));
  Vec3 spring = vec3(p.springs + 4 * k);
  const auto f =
      touch<3, law, friction>(rule.law, touched.normal, touched.overlap, p.mbar[k], v, Vec3{}, spring, rule.dt);
  p.tally->damped[slot] += f.damped;
  p.tally->rubbed[slot] += f.rubbed;
  p.tally->excess[slot] = larger(p.tally->excess[slot], touched.overlap - smaller(one[3], two[3]));
  const Vec3 force = (-f.normal) * touched.normal + f.tangential;
  const Vec3 torque_i = cross(lever_i, force), torque_j = cross(lever_j, force);
  double *fi = p.forces + R::force_stride * p.i[k], *fj = p.forces + R::force_stride * p.j[k];
  for (int e = 0; e < 3; ++e) {
    fi[e] += force[e], fi[4 + e] += torque_i[e];
    fj[e] -= force[e], fj[4 + e] -= torque_j[e];
    if constexpr (friction) p.springs[4 * k + static_cast<std::size_t>(e)] = spring[e];
  }
}

void press(const PressArrays& p) {
  with_rule(*p.rule, [&]<NormalLaw law, bool friction, ParallelRule parallel>() {
    for (std::size_t c = 0; c < p.contacts; ++c) press_pair<law, friction, parallel>(p, p.pair[c], c);
  });
}

std::size_t press_listed(const PressArrays& p) {
  const std::size_t count = collect({p.arms, p.arm_i, p.arm_j, p.pairs, p.pair, p.touching});
  PressArrays collected = p;
  collected.contacts = count;
  press(collected);
  return count;
}

}  // namespace

const ClusterKernels& plain_cluster_kernels() {
  static const ClusterKernels kernels{"plain", near, collect, press, press_listed, integrate};
  return kernels;
}

}  // namespace jam
