#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

#include "jamscape/base/error.hpp"
#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/hdf5_calls.hpp"

namespace jam::hdf5 {

namespace {

/// The oldest format in which every piece of metadata carries a checksum, so that damage is noticed rather than read.
Handle file_access() {
  Handle list = property_list(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(list.id(), H5F_LIBVER_V110, H5F_LIBVER_LATEST);
  H5Pset_file_locking(list.id(), false, true);  // locks fail on some network file systems and guard nothing here
  return list;
}

Handle create_in(Storage& storage, const std::string& name) {
  const Handle creation = property_list(H5P_FILE_CREATE), access = file_access();
  use_storage(access.id(), storage);
  Handle made(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  check(made.id(), name, "create the file");
  return made;
}

Handle open_in(hid_t access, const std::string& name) {
  Handle opened(H5Fopen(name.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
  check(opened.id(), name, "open it as an HDF5 file");
  return opened;
}

}  // namespace

File File::create(const std::filesystem::path& path) {
  const Lock lock;
  auto disk = std::make_unique<DiskStorage>(path);
  Handle made = create_in(*disk, path.string());
  File file(std::move(made), path.string(), nullptr, std::move(disk));
  file.check();
  return file;
}

File File::create_image(const std::string& name) {
  const Lock lock;
  auto memory = std::make_unique<MemoryStorage>();
  Handle made = create_in(*memory, name);
  return {std::move(made), name, std::move(memory), nullptr};
}

File File::open(const std::filesystem::path& path) {
  const Lock lock;
  return {open_in(file_access().id(), path.string()), path.string(), nullptr, nullptr};
}

File File::open_image(std::string image, const std::string& name) {
  const Lock lock;
  auto memory = std::make_unique<MemoryStorage>(std::move(image));
  const Handle access = file_access();
  use_storage(access.id(), *memory);
  Handle opened = open_in(access.id(), name);
  return {std::move(opened), name, std::move(memory), nullptr};
}

Group File::root() const {
  const Lock lock;
  Handle opened(H5Gopen2(handle_.id(), "/", H5P_DEFAULT), H5Gclose);
  jam::hdf5::check(opened.id(), name_, "open the root group");
  return {std::move(opened), name_, "/"};
}

void File::check() const {
  if (disk_ && disk_->failure() != 0)
    throw data_error(fmt::format("cannot write the file: {}", std::strerror(disk_->failure())), name_,
                     "make room on the disk, or write elsewhere");
}

void File::must_be_alone() const {
  if (H5Fget_obj_count(handle_.id(), H5F_OBJ_ALL) > 1)
    throw std::logic_error(name_ + ": closed before the groups and arrays in it");
}

void File::close() {
  const Lock lock;
  must_be_alone();
  if (!handle_.reset()) fail(name_, "close the file");
  check();
}

std::string File::close_image() {
  const Lock lock;
  must_be_alone();
  if (!handle_.reset()) fail(name_, "close the file");
  return memory_->take();
}

}  // namespace jam::hdf5
