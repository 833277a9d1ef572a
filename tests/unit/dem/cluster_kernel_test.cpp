// One step of the contact loops of clusters: every vector width gives the bits of the plain one, whether pairs are
// collected first or not.
#include "jamscape/dem/cluster_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "jamscape/base/random.hpp"
#include "jamscape/geometry/cluster_shape.hpp"

namespace jam {
namespace {

struct Scene {
  ClusterState bodies;
  ArmPairs pairs;
  ArmContacts contacts;
  ClusterTally tally{};

  explicit Scene(bool friction) {
    Random random(3, "clusters", 0, "scene");
    const std::vector<ClusterShape> shapes{star_shape(4), rod_shape(3), cross_shape(5)};
    ClusterBodies b;
    for (std::size_t k = 0; k < 40; ++k) {
      b.shape.push_back(static_cast<std::int32_t>(k % 3));
      b.scale.push_back(random.uniform(0.8, 1.2));
      const auto vector = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
      };
      b.position.push_back(vector(3));
      b.velocity.push_back(vector(0.1));
      b.spin.push_back(vector(0.1));
      b.orientation.push_back(normalized({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 0.1}));
    }
    append_bodies(bodies, b, shapes, 1, false);
    const auto arms = static_cast<std::uint32_t>(bodies.arm_count());
    for (std::size_t k = 0; k < 100 * block; ++k) {  // of random arms about every ninth pair touches
      const auto one = static_cast<std::uint32_t>(random.below(arms)),
                 two = static_cast<std::uint32_t>(random.below(arms));
      const bool padding = k + 3 >= 100 * block || bodies.arm_body[one] == bodies.arm_body[two];
      pairs.arm_i.push_back(padding ? arms : one), pairs.arm_j.push_back(padding ? arms + 1 : two);
      pairs.i.push_back(padding ? 0 : bodies.arm_body[one]), pairs.j.push_back(padding ? 0 : bodies.arm_body[two]);
      pairs.mbar.push_back(random.uniform(0.3, 0.7));
      for (int e = 0; e < 3; ++e) pairs.springs.push_back(friction && !padding ? random.uniform(-0.2, 0.2) : 0);
      pairs.springs.push_back(0);
    }
    pairs.count = pairs.i.size() - 3;
    contacts.resize(pairs.size());
    std::fill(std::begin(tally.excess), std::end(tally.excess), -1.0);
  }
};

struct Outcome {
  std::size_t contacts;
  std::vector<double> numbers;
  std::vector<std::uint8_t> touching;
};

Outcome press(const ClusterKernels& kernels, NormalLaw law, bool friction, ParallelRule parallel, bool listed) {
  Scene s(friction);
  const double sine = std::sin(0.2);
  const PressRule rule{{1, 0.4, 0.8, 0.3, 1 / 0.8, friction ? 0.2 : 0, 0, 0, false}, law, parallel, sine * sine, 0.02};
  if (!listed) s.contacts.count = kernels.collect(collect_arrays(s.bodies, s.pairs, s.contacts));
  const PressArrays p = press_arrays(s.bodies, s.pairs, s.contacts, rule, s.tally);
  listed ? void(s.contacts.count = kernels.press_listed(p)) : kernels.press(p);
  Outcome out{s.contacts.count, {}, {s.contacts.touching.begin(), s.contacts.touching.end()}};
  for (const auto* numbers : {&s.bodies.forces, &s.pairs.springs})
    out.numbers.insert(out.numbers.end(), numbers->begin(), numbers->end());
  for (const auto* sums : {&s.tally.damped, &s.tally.rubbed})
    out.numbers.insert(out.numbers.end(), std::begin(*sums), std::end(*sums));
  out.numbers.push_back(*std::max_element(std::begin(s.tally.excess), std::end(s.tally.excess)));
  return out;
}

TEST(ClusterKernels, all_widths_and_both_ways_give_the_bits_of_the_plain_one) {
  const auto plain_one = [](ParallelRule rule) {
    return press(plain_cluster_kernels(), NormalLaw::linear, true, rule, false).numbers;
  };
  EXPECT_NE(plain_one(ParallelRule::middle), plain_one(ParallelRule::blend)) << "no parallel arms among them";
  for (const NormalLaw law : {NormalLaw::linear, NormalLaw::hertz, NormalLaw::tsuji, NormalLaw::ratio})
    for (const bool friction : {false, true})
      for (const ParallelRule parallel : {ParallelRule::middle, ParallelRule::blend}) {
        const Outcome plain = press(plain_cluster_kernels(), law, friction, parallel, false);
        EXPECT_GT(plain.contacts, 40u);
        EXPECT_LT(plain.contacts, 400u);
        for (const ClusterKernels* kernels : available_cluster_kernels())
          for (const bool listed : {false, true}) {
            const Outcome wide = press(*kernels, law, friction, parallel, listed);
            EXPECT_EQ(wide.contacts, plain.contacts);
            EXPECT_EQ(wide.touching, plain.touching);
            ASSERT_EQ(wide.numbers.size(), plain.numbers.size());
            for (std::size_t q = 0; q < plain.numbers.size(); ++q)
              ASSERT_EQ(std::memcmp(&wide.numbers[q], &plain.numbers[q], sizeof(double)), 0)
                  << kernels->name << (listed ? ", listed" : ", collected") << ", law " << static_cast<int>(law)
                  << ": number " << q << " is " << wide.numbers[q] << " instead of " << plain.numbers[q];
          }
      }
}

TEST(ClusterKernels, near_arms_are_those_of_the_plain_one) {
  const Scene s(false);
  std::vector<std::vector<std::uint32_t>> found;
  Aligned<double> skin(s.pairs.size());
  for (std::size_t k = 0; k < skin.size(); ++k) skin[k] = 0.01 * static_cast<double>(k % 100);
  for (const ClusterKernels* kernels : available_cluster_kernels()) {
    Aligned<std::uint32_t> near(s.pairs.size() + block);
    const std::size_t count = kernels->near(
        {s.bodies.arms.data(), s.pairs.arm_i.data(), s.pairs.arm_j.data(), skin.data(), s.pairs.size(), near.data()});
    found.emplace_back(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count));
    EXPECT_EQ(found.back(), found.front()) << kernels->name;
  }
  EXPECT_GT(found.front().size(), 100u);
}

}  // namespace
}  // namespace jam
