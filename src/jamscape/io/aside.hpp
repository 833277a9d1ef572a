// Write aside, then rename, for files that grow on the disk; base/files.hpp does it for those that fit in memory.
#pragma once

#include <filesystem>

namespace jam {

/// Names `TARGET.part` beside the target. The destructor removes that file unless commit() was reached.
class Aside {
 public:
  /// Throws a data error when the target is a folder or the file beside it cannot be made.
  explicit Aside(std::filesystem::path target);
  ~Aside();
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Forces the bytes to the disk and renames; throws a data error and leaves the target as it was.
  void commit();

 private:
  std::filesystem::path target_, path_;
  bool committed_ = false;
};

}  // namespace jam
