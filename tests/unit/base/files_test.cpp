#include "jamscape/base/files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "jamscape/base/error.hpp"
#include "jamscape/base/file_lacks.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() { fs::create_directories(folder_); }
  ~Files() override { fs::remove_all(folder_); }
  fs::path folder_ = fs::temp_directory_path() / ("jamscape-files-" + std::to_string(::getpid()));
};

TEST_F(Files, TextComesBack) {
  const std::string text("a\0b\n", 4);
  write_text(folder_ / "x", text);
  EXPECT_EQ(read_text(folder_ / "x"), text);
  write_text(folder_ / "x", "other");
  EXPECT_EQ(read_text(folder_ / "x"), "other");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "nothing is left beside it";
}

TEST_F(Files, EqualTextIsNotWrittenAgain) {
  write_text(folder_ / "x", "same");
  const auto before = fs::last_write_time(folder_ / "x") - std::chrono::hours(1);
  fs::last_write_time(folder_ / "x", before);
  write_text(folder_ / "x", "same");
  EXPECT_EQ(fs::last_write_time(folder_ / "x"), before);
}

TEST_F(Files, AFailedWriteLeavesTheOldContent) {
  fs::create_directories(folder_ / "x.part");  // the place beside it is taken
  std::ofstream(folder_ / "x") << "old";
  EXPECT_THROW(write_text(folder_ / "x", "new"), Error);
  EXPECT_EQ(read_text(folder_ / "x"), "old");
}

TEST_F(Files, AMissingFileIsNamed) {
  try {
    read_text(folder_ / "none");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::data);
    EXPECT_NE(e.place().find("none"), std::string::npos);
  }
}

TEST_F(Files, AFullDiskIsSaid) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  fs::create_symlink("/dev/full", folder_ / "x.part");
  try {
    write_text(folder_ / "x", "text");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(e.suggestion().find("make room"), std::string::npos);
  }
}

TEST_F(Files, OnlyOneHoldsALock) {
  const fs::path file = folder_ / "lock";
  {
    const auto first = FileLock::try_lock(file);
    ASSERT_TRUE(first);
    EXPECT_EQ(read_text(file), std::to_string(::getpid()) + "\n");
    EXPECT_FALSE(FileLock::try_lock(file));
    EXPECT_FALSE(FileLock::try_lock(file, LockMode::shared));
  }
  EXPECT_TRUE(FileLock::try_lock(file)) << "given back";
}

TEST_F(Files, ALockThatMayNotBeWrittenIsStillALock) {
  std::ofstream(folder_ / "lock") << "123\n";
  fs::permissions(folder_ / "lock", fs::perms::owner_read);
  const auto first = FileLock::try_lock(folder_ / "lock", LockMode::shared);
  EXPECT_TRUE(first);
  EXPECT_FALSE(FileLock::try_lock(folder_ / "lock"));
}

TEST_F(Files, AScratchFolderIsGoneAfterwards) {
  fs::path path;
  {
    const ScratchFolder scratch("test"), other("test");
    path = scratch.path();
    EXPECT_NE(path, other.path());
    write_text(path / "x", "text");
    EXPECT_TRUE(may_write(path));
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_FALSE(may_write(path));
}

TEST_F(Files, WhatAFileSystemLacksIsNotedOnce) {
  for (const int code : {ENOLCK, ENOSYS, EOPNOTSUPP, EINVAL, 524}) EXPECT_TRUE(is_lack(code));
  for (const int code : {ENOSPC, EDQUOT, EIO, EROFS, EACCES, EWOULDBLOCK}) EXPECT_FALSE(is_lack(code));
  take_lacks();
  note_lack(Lack::locks, "/some/where/lock", ENOLCK);
  note_lack(Lack::locks, "/else/where/lock", ENOLCK);
  const std::vector<std::string> lacks = take_lacks();
  ASSERT_EQ(lacks.size(), 1u);
  EXPECT_NE(lacks[0].find("/some/where: this file system has no locks"), std::string::npos);
  EXPECT_TRUE(take_lacks().empty());
}

/// A pipe cannot be forced to a disk: EINVAL.
TEST_F(Files, WhatCannotBeForcedToADiskIsBorne) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_EQ(force_to_disk(ends[1], folder_ / "x"), 0);
  EXPECT_EQ(force_to_disk(-1, folder_ / "x"), EBADF);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_F(Files, SharedLocksGoTogether) {
  const auto a = FileLock::try_lock(folder_ / "lock", LockMode::shared);
  const auto b = FileLock::try_lock(folder_ / "lock", LockMode::shared);
  EXPECT_TRUE(a && b);
  EXPECT_FALSE(FileLock::try_lock(folder_ / "lock"));
}

}  // namespace
}  // namespace jam
