#include "jamscape/io/archive_file.hpp"

#include <bit>
#include <limits>

#include "packings.hpp"

namespace jam {
namespace {

using namespace testing;

Archive sample() {
  std::mt19937_64 generator(3);
  std::vector<double> many(5000);
  for (double& x : many) x = std::bit_cast<double>(generator());
  return {{"state/position", many},
          {"state/spring/tangential", std::vector<double>{-0.0, std::numeric_limits<double>::denorm_min(),
                                                          std::bit_cast<double>(0x7ff4dead0000beefULL)}},
          {"state/empty", std::vector<double>{}},
          {"step", std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(), 7}},
          {"none", std::vector<std::int64_t>{}},
          {"stage", std::string("press\0ed ρ", 11)},
          {"nothing", std::string()}};
}

void expect_same(const Archive& a, const Archive& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, value] : a) {
    ASSERT_TRUE(b.contains(name)) << name;
    ASSERT_EQ(value.index(), b.at(name).index()) << name;
    if (const auto* numbers = std::get_if<std::vector<double>>(&value))
      EXPECT_TRUE(same_bits(*numbers, std::get<std::vector<double>>(b.at(name)))) << name;
    else
      EXPECT_EQ(value, b.at(name)) << name;
  }
}

TEST(ArchiveFile, KeepsEveryBit) {
  const Folder folder;
  write_archive(folder / "checkpoint.h5", sample());
  expect_same(sample(), read_archive(folder / "checkpoint.h5"));
  EXPECT_EQ(folder.files(), 1u);
}

TEST(ArchiveFile, AnEmptyArchive) {
  const Folder folder;
  write_archive(folder / "checkpoint.h5", {});
  EXPECT_TRUE(read_archive(folder / "checkpoint.h5").empty());
}

TEST(ArchiveFile, EqualContentGivesEqualBytes) {
  const Folder folder;
  write_archive(folder / "a.h5", sample());
  write_archive(folder / "b.h5", sample());
  EXPECT_EQ(bytes_of(folder / "a.h5"), bytes_of(folder / "b.h5"));
}

TEST(ArchiveFile, ReplacesAnOlderOne) {
  const Folder folder;
  write_archive(folder / "checkpoint.h5", {{"step", std::vector<std::int64_t>{1}}});
  write_archive(folder / "checkpoint.h5", sample());
  expect_same(sample(), read_archive(folder / "checkpoint.h5"));
}

TEST(ArchiveFile, ANameThatIsBothArrayAndGroup) {
  const Folder folder;
  const Archive archive{{"a", std::string("x")}, {"a/b", std::string("y")}};
  EXPECT_NE(error_of([&] { write_archive(folder / "checkpoint.h5", archive); }).find("'/a': not a group"),
            std::string::npos);
  EXPECT_EQ(folder.files(), 0u);
}

TEST(ArchiveFile, TruncatedAnywhere) {
  const Folder folder;
  write_archive(folder / "whole.h5", sample());
  const std::string whole = bytes_of(folder / "whole.h5");
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 97) {
    put_bytes(folder / "part.h5", whole.substr(0, size));
    EXPECT_NE(error_of([&] { read_archive(folder / "part.h5"); }).find("part.h5: "), std::string::npos);
  }
}

TEST(ArchiveFile, AWrongBitAnywhere) {
  const Folder folder;
  write_archive(folder / "whole.h5", sample());
  const std::string whole = bytes_of(folder / "whole.h5");
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 97) {
    std::string wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] ^ (1 << (at % 8)));
    put_bytes(folder / "wrong.h5", wrong);
    EXPECT_NE(error_of([&] { read_archive(folder / "wrong.h5"); }).find("wrong.h5: the file is"), std::string::npos);
  }
}

TEST(ArchiveFile, MissingAndFolder) {
  const Folder folder;
  EXPECT_NE(error_of([&] { read_archive(folder / "none.h5"); }).find("No such file"), std::string::npos);
  EXPECT_NE(error_of([&] { read_archive(folder / ""); }).find("irectory"), std::string::npos);
}

TEST(ArchiveFile, AFullDiskKeepsTheOlderOne) {
  const Folder folder;
  write_archive(folder / "checkpoint.h5", {{"step", std::vector<std::int64_t>{1}}});
  {
    const FullDisk full(8192);
    EXPECT_NE(error_of([&] { write_archive(folder / "checkpoint.h5", sample()); }).find("too large"),
              std::string::npos);
  }
  EXPECT_EQ(read_archive(folder / "checkpoint.h5").size(), 1u);
  EXPECT_EQ(folder.files(), 1u);
}

}  // namespace
}  // namespace jam
