#include "jamscape/study/task.hpp"

#include <gtest/gtest.h>

#include <set>

#include "jamscape/base/error.hpp"
#include "small_study.hpp"

namespace jam {
namespace {

std::vector<Task> tasks(const std::string& more = {}) {
  return plan_tasks(read_study_text(std::string(small_study) + more, "s.toml"));
}

TEST(Tasks, OneForEachSystemAndRealisation) {
  const std::vector<Task> t = tasks();
  ASSERT_EQ(t.size(), 6u);
  std::set<std::string> hashes;
  for (const Task& task : t) hashes.insert(task.hash);
  EXPECT_EQ(hashes.size(), 6u);
  EXPECT_EQ(t[4].system, 1u);
  EXPECT_EQ(t[4].realisation, 1u);
}

TEST(Tasks, MoreRealisationsAndSystemsLeaveTheOthersAsTheyAre) {
  const std::vector<Task> before = tasks();
  const std::vector<Task> after =
      plan_tasks(read_study_text(std::string(small_study) + "[[system]]\nname = \"new\"\ncontact.friction = 0.1\n",
                                 "s.toml", {{"study.realisations", "5"}, {"study.title", "new"}}));
  ASSERT_EQ(after.size(), 15u);
  for (const Task& b : before) {
    const Task& a = after[b.system * 5 + b.realisation];
    EXPECT_EQ(a.hash, b.hash);
    EXPECT_EQ(a.key.system, b.key.system);
  }
}

TEST(Tasks, EqualPhysicsIsDoneOnce) {
  const std::vector<Task> t = tasks("[[system]]\nname = \"again\"\ncontact.friction = 0\n");
  EXPECT_EQ(t.size(), 9u);
  EXPECT_EQ(order_tasks(t, {}).size(), 6u);
}

TEST(Tasks, LongestFirstAndEnsemblesGrowEvenly) {
  const std::vector<Task> t = tasks("[[system]]\nname = \"smoother\"\ncontact.friction = 0.1\n");
  std::vector<std::pair<std::string, std::uint64_t>> order;
  const char* names[] = {"smooth", "rough", "smoother"};
  for (const std::size_t k : order_tasks(t, {})) order.emplace_back(names[t[k].system], t[k].realisation);
  EXPECT_EQ(order, (decltype(order){{"smooth", 0},
                                    {"smoother", 0},
                                    {"smooth", 1},
                                    {"smoother", 1},
                                    {"smooth", 2},
                                    {"smoother", 2},
                                    {"rough", 0},
                                    {"rough", 1},
                                    {"rough", 2}}))
      << "rough is compressed at twice the speed";
}

TEST(Tasks, ShardsShareThemOut) {
  const std::vector<Task> t = tasks();
  std::multiset<std::size_t> all;
  for (int i = 1; i <= 4; ++i)
    for (const std::size_t k : order_tasks(t, {i, 4})) all.insert(k);
  EXPECT_EQ(all, (std::multiset<std::size_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Tasks, ShardsAreReadStrictly) {
  EXPECT_EQ(read_shard("2/3").index, 2);
  EXPECT_EQ(read_shard("2/3").count, 3);
  for (const char* bad : {"", "1", "0/2", "3/2", "1/2/3", "a/b", "1/-1"}) EXPECT_THROW(read_shard(bad), Error) << bad;
}

TEST(Tasks, AnImpossibleProtocolNamesItsPlace) {
  try {
    tasks("[[system]]\nname = \"back\"\nstage.compress.to = 0.3\n");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::usage);
    EXPECT_EQ(e.place(), "s.toml:26:16");
    EXPECT_NE(e.problem().find("system 'back'"), std::string::npos);
  }
}

}  // namespace
}  // namespace jam
