#include "jamscape/observe/snapshot.hpp"

#include <gtest/gtest.h>

#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

std::vector<std::pair<double, double>> points(const Snapshot& s) {
  std::vector<std::pair<double, double>> list;
  for (const PersistencePair& p : s.diagram().pairs) list.emplace_back(p.birth, p.death);
  return list;
}

TEST(Snapshot, MemorySharedWithAnotherInfluencesNothing) {
  const Packing large = cloud(2, 200, 9), small = hexagonal(6, 4);
  const Snapshot large_alone(large, {}), small_alone(small, {});
  SnapshotMemory memory;
  for (int round = 0; round < 2; ++round) {
    const Snapshot a(large, {}, &memory), b(small, {}, &memory);  // both at once, by turns
    a.history();
    EXPECT_EQ(points(b), points(small_alone));
    EXPECT_EQ(a.levels(), large_alone.levels());
    EXPECT_EQ(points(a), points(large_alone));
    EXPECT_EQ(b.levels(), small_alone.levels());
  }
}

}  // namespace
}  // namespace jam
