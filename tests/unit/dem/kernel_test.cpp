// One step of the contact loop of discs and spheres: every vector width gives the bits of the plain one, for pairs that
// touch, have parted and never met, side by side in one block.
#include "jamscape/dem/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "jamscape/base/random.hpp"
#include "jamscape/dem/periodic.hpp"

namespace jam {
namespace {

constexpr std::size_t bodies = 60, listed = 40 * block;

template <int D>
struct Scene {
  static constexpr std::size_t spring_size = D == 2 ? 1 : 3;
  Aligned<double> rows, forces, mbar, springs, shifts;
  Aligned<std::uint32_t> i, j, shift, watch_i, watch_j, watch_shift, watch_pair;
  Aligned<std::uint8_t> watch_touching;
  Tally tally{};
  PairRange range;

  Scene(NormalLaw law, bool friction, bool sparse, std::uint64_t seed) {
    using R = Row<D>;
    Random random(seed, "kernels", 0, "scene");
    rows.assign((bodies + 2) * R::stride, 0.0);
    forces.assign((bodies + 2) * R::force_stride, 0.0);
    const double side = D == 2 ? 3 : 2;  // crowded, so that many pairs touch
    for (std::size_t k = 0; k < bodies; ++k) {
      double* row = rows.data() + k * R::stride;
      for (std::size_t c = 0; c < D; ++c)
        row[c] = random.uniform(0, side), row[R::velocity + c] = random.uniform(-0.1, 0.1);
      row[R::radius] = random.uniform(0.4, 0.6);
      for (std::size_t c = 0; c < spring_size; ++c) row[R::spin + c] = random.uniform(-0.1, 0.1);
    }
    for (std::size_t k = 0; k < 2; ++k) rows[(bodies + k) * R::stride] = k == 0 ? -1e15 : 1e15;  // nobody
    shifts = image_shifts(Periodic<D>{{}, {side, side}});
    springs.assign(listed * spring_size, 0.0);
    for (std::size_t k = 0; k < listed; ++k) {
      const bool padding = k + 5 >= listed;
      const auto a = static_cast<std::uint32_t>(random.below(bodies - 1));
      i.push_back(padding ? bodies : a);
      j.push_back(padding ? bodies + 1 : a + 1 + static_cast<std::uint32_t>(random.below(bodies - 1 - a)));
      shift.push_back(padding || random.below(4) ? no_shift<D> : static_cast<std::uint32_t>(random.below(images<D>)));
      mbar.push_back(random.uniform(0.3, 0.7));
      if (friction && !padding && random.below(3))
        for (std::size_t c = 0; c < spring_size; ++c)
          springs[D == 2 ? k : k / block * 3 * block + c * block + k % block] = random.uniform(-0.3, 0.3);
    }
    for (auto* array : {&watch_i, &watch_j, &watch_shift, &watch_pair}) array->assign(listed, 0);
    watch_touching.assign(listed / block, 0);
    for (std::size_t s = 0; s < block; ++s) tally.rubbed[s] = tally.damped[s] = 1e-3 * static_cast<double>(s + 1);
    const PairLaw<> constants{1, 0.4, 0.8, 0.3, 1 / 0.8, friction ? 0.2 : 0, 0.5, 0, false};
    range = {0, listed, sparse, 0, constants, law, friction};
  }

  PairArrays arrays(bool shifted) {
    return {rows.data(),
            forces.data(),
            i.data(),
            j.data(),
            mbar.data(),
            springs.data(),
            shifted ? shift.data() : nullptr,
            shifts.data(),
            0.02,
            shifted ? 0.03 : 0,  // a periodic box shrinks
            &tally,
            {watch_i.data(), watch_j.data(), watch_shift.data(), watch_pair.data(), watch_touching.data()},
            bodies};
  }
};

/// Forces, springs and sums after three steps; the bodies are moved by hand in between, so that pairs meet and part.
template <int D>
std::vector<double> three_steps(const Kernels& kernels, NormalLaw law, bool friction, bool sparse, bool shifted) {
  Scene<D> scene(law, friction, sparse, 7);
  const PairArrays p = scene.arrays(shifted);
  if (sparse) scene.range.watched = kernels.watch<D>()(p, scene.range, 1.0);
  std::vector<double> out;
  for (int step = 0; step < 3; ++step) {
    kernels.pairs<D>()(p, scene.range);
    out.insert(out.end(), scene.forces.begin(), scene.forces.end());
    out.insert(out.end(), scene.springs.begin(), scene.springs.end());
    for (const auto* sums : {&scene.tally.damped, &scene.tally.rubbed, &scene.tally.virial})
      out.insert(out.end(), std::begin(*sums), std::end(*sums));
    out.push_back(*std::max_element(std::begin(scene.tally.deepest), std::end(scene.tally.deepest)));
    Random random(9, "kernels", static_cast<std::uint64_t>(step), "moves");
    for (std::size_t k = 0; k < bodies; ++k)
      for (std::size_t c = 0; c < D; ++c) scene.rows[k * Row<D>::stride + c] += random.uniform(-0.2, 0.2);
  }
  return out;
}

template <int D>
void expect_equal_bits() {
  for (const NormalLaw law : {NormalLaw::linear, NormalLaw::hertz, NormalLaw::tsuji})
    for (int choice = 0; choice < 8; ++choice) {
      const bool friction = choice & 1, sparse = choice & 2, shifted = choice & 4;
      const std::vector<double> plain = three_steps<D>(plain_kernels(), law, friction, sparse, shifted);
      EXPECT_GT(std::count_if(plain.begin(), plain.end(), [](double a) { return a != 0; }), 300);
      for (const Kernels* kernels : available_kernels().subspan(1)) {
        const std::vector<double> wide = three_steps<D>(*kernels, law, friction, sparse, shifted);
        ASSERT_EQ(wide.size(), plain.size());
        for (std::size_t q = 0; q < plain.size(); ++q)
          ASSERT_EQ(std::memcmp(&wide[q], &plain[q], sizeof(double)), 0)
              << kernels->name << ", law " << static_cast<int>(law) << (friction ? ", friction" : "")
              << (sparse ? ", sparse" : "") << (shifted ? ", shifted" : "") << ": number " << q << " is " << wide[q]
              << " instead of " << plain[q];
      }
    }
}

TEST(Kernels, all_widths_give_the_bits_of_the_plain_one_for_discs) { expect_equal_bits<2>(); }
TEST(Kernels, all_widths_give_the_bits_of_the_plain_one_for_spheres) { expect_equal_bits<3>(); }

}  // namespace
}  // namespace jam
