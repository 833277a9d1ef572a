// One pair after another: the reference.
#include "jamscape/dem/integrate_body.hpp"
#include "jamscape/dem/kernel.hpp"
#include "jamscape/dem/spin.hpp"

namespace jam {
namespace {

template <int D, NormalLaw law, bool friction>
void pair_loop(const PairArrays& p, const PairRange& range) {
  using R = Row<D>;
  std::size_t touching = 0;
  for (std::size_t k = range.begin; k < range.end; ++k) {
    const double* a = p.rows + p.i[k] * R::stride;
    const double* b = p.rows + p.j[k] * R::stride;
    double* stored = p.springs + (D == 2 ? k : k / block * 3 * block + k % block);
    Axial<D> spring;
    if constexpr (D == 2)
      spring = stored[0];
    else
      spring = {stored[0], stored[block], stored[2 * block]};

    Vec<D> d, v;
    for (int c = 0; c < D; ++c) {
      const double shift = p.shift ? p.shifts[4 * p.shift[k] + static_cast<std::size_t>(c)] : 0.0;
      d[c] = (p.shift ? b[c] + shift : b[c]) - a[c];
      v[c] = a[R::velocity + static_cast<std::size_t>(c)] - b[R::velocity + static_cast<std::size_t>(c)];
      if (p.shrinking != 0) v[c] = add_product<fused<D>>(v[c], p.shrinking, d[c]);
    }
    const double reach = a[R::radius] + b[R::radius], r2 = dot<fused<D>>(d, d);
    if (!(r2 < reach * reach)) {
      if constexpr (friction) {
        if constexpr (!hertzian(law)) p.tally->rubbed[k % block] += spring_energy(range.law.k_t, spring);
        for (std::size_t c = 0; c < (D == 2 ? 1 : 3); ++c) stored[c * block] = 0;
      }
      continue;
    }
    const std::size_t slot = (range.sparse ? touching++ : k) % block;
    const double r = square_root(r2), inverse = 1.0 / r, x = reach - r;
    const Vec<D> n = inverse * d;
    const double lever_i = subtract_product<fused<D>>(a[R::radius], range.law.lever_cut, x);
    const double lever_j = subtract_product<fused<D>>(b[R::radius], range.law.lever_cut, x);
    const Axial<D> lw = add_product<fused<D>>(levered_spin<D>(b, lever_j), lever_i, spin_of<D>(a));
    const auto f = touch<D, law, friction, fused<D>>(range.law, n, x, p.mbar[k], v, lw, spring, p.dt);
    p.tally->damped[slot] += f.damped;
    p.tally->rubbed[slot] += f.rubbed;
    p.tally->virial[slot] = add_product<fused<D>>(p.tally->virial[slot], f.normal, r);
    p.tally->deepest[slot] = larger(p.tally->deepest[slot], x);

    double* fi = p.forces + p.i[k] * R::force_stride;
    double* fj = p.forces + p.j[k] * R::force_stride;
    if constexpr (D == 2) {
      const double push = -f.normal;
      const double fx = push * n[0] - f.tangential * n[1], fy = push * n[1] + f.tangential * n[0];
      fi[0] += fx, fi[1] += fy, fi[2] += lever_i * f.tangential;
      fj[0] -= fx, fj[1] -= fy, fj[2] += lever_j * f.tangential;
      if constexpr (friction) stored[0] = spring;
    } else {
      const Vec<3> total = subtract_product<fused<D>>(f.tangential, f.normal, n),
                   twist = cross<fused<D>>(n, f.tangential);
      for (int c = 0; c < 3; ++c) {
        fi[c] += total[c];
        fi[4 + c] += lever_i * twist[c];
        fj[c] -= total[c];
        fj[4 + c] += lever_j * twist[c];
        if constexpr (friction) stored[static_cast<std::size_t>(c) * block] = spring[c];
      }
    }
  }
}

template <int D>
void pairs(const PairArrays& p, const PairRange& range) {
  with_law(range.kind, [&]<NormalLaw law>() {
    range.friction ? pair_loop<D, law, true>(p, range) : pair_loop<D, law, false>(p, range);
  });
}

/// It tests every pair anyway.
std::size_t watch_all(const PairArrays&, const PairRange&, double) { return 0; }

template <int D>
std::size_t near(const NearQuery& s, const NearBodies& out) {
  std::size_t n = 0;
  for (std::size_t r = 0; r < s.range_count; ++r) {
    const CandidateRange& range = s.ranges[r];
    for (std::uint32_t q = range.from; q < range.to; ++q) {
      Vec<D> d;
      for (int e = 0; e < D; ++e)
        d[e] = (s.x[e][q] + s.shifts[4 * range.shift + static_cast<std::size_t>(e)]) - s.row[e];
      const double r2 = dot(d, d), reach = s.row[Row<D>::radius] + s.radius[q], far = reach + s.skin;
      if (s.body[q] <= s.a || !(r2 < far * far)) continue;
      out.body[n] = s.body[q] | (r2 < reach * reach ? NearBodies::touching : 0);
      out.shift[n++] = range.shift;
    }
  }
  return n;
}

}  // namespace

const Kernels& plain_kernels() {
  static const Kernels kernels{"plain", pairs<2>,  pairs<3>,  watch_all, watch_all, near<2>,
                               near<3>, verlet<2>, verlet<3>, gear<2>,   gear<3>};
  return kernels;
}

}  // namespace jam
