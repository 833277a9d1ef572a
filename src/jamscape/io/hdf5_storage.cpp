#include "jamscape/io/hdf5_storage.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

namespace jam::hdf5 {

// ---- memory

void MemoryStorage::read(std::uint64_t address, std::size_t size, char* out) const {
  const std::size_t there = address < bytes_.size() ? std::min<std::size_t>(size, bytes_.size() - address) : 0;
  if (there > 0) std::memcpy(out, bytes_.data() + address, there);
  std::memset(out + there, 0, size - there);
}

void MemoryStorage::write(std::uint64_t address, std::size_t size, const char* bytes) {
  if (address + size > bytes_.size()) bytes_.resize(address + size);
  std::memcpy(bytes_.data() + address, bytes, size);
}

// ---- disk

DiskStorage::DiskStorage(const std::filesystem::path& path)
    : descriptor_(::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) failure_ = errno;
}

DiskStorage::~DiskStorage() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void DiskStorage::resize(std::uint64_t size) {
  size_ = size;
  if (failure_ == 0 && ::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) failure_ = errno;
}

void DiskStorage::read(std::uint64_t address, std::size_t size, char* out) const {
  std::memset(out, 0, size);
  for (std::size_t done = 0; descriptor_ >= 0 && done < size;) {
    const ssize_t n = ::pread(descriptor_, out + done, size - done, static_cast<off_t>(address + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    done += static_cast<std::size_t>(n);
  }
  for (const auto& [start, bytes] : unwritten_) {
    const std::uint64_t first = std::max(start, address), last = std::min(start + bytes.size(), address + size);
    if (first < last) std::memcpy(out + (first - address), bytes.data() + (first - start), last - first);
  }
}

bool DiskStorage::try_write(std::uint64_t address, std::size_t size, const char* bytes) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = ::pwrite(descriptor_, bytes + done, size - done, static_cast<off_t>(address + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

void DiskStorage::write(std::uint64_t address, std::size_t size, const char* bytes) {
  size_ = std::max(size_, address + size);
  if (failure_ == 0 && !try_write(address, size, bytes)) failure_ = errno;
  if (failure_ != 0) unwritten_.emplace_back(address, std::string(bytes, size));
}

// ---- driver

namespace {

/// What the library holds of an open file; it fills `base` itself.
struct OpenFile {
  H5FD_t base;
  Storage* storage;
  haddr_t end_of_allocation;
};

struct Info {
  Storage* storage;
};

OpenFile* ours(H5FD_t* file) { return reinterpret_cast<OpenFile*>(file); }
const OpenFile* ours(const H5FD_t* file) { return reinterpret_cast<const OpenFile*>(file); }

H5FD_t* open_file(const char*, unsigned flags, hid_t access_list, haddr_t) {
  const auto* info = static_cast<const Info*>(H5Pget_driver_info(access_list));
  if (!info) return nullptr;
  if (flags & H5F_ACC_TRUNC) info->storage->resize(0);
  auto* file = new (std::nothrow) OpenFile{};
  if (!file) return nullptr;
  file->storage = info->storage;
  return &file->base;
}

template <class Call>
herr_t guarded(Call call) {
  try {
    call();
    return 0;
  } catch (const std::bad_alloc&) {
    return -1;
  }
}

const H5FD_class_t& driver_class() {
  static const H5FD_class_t driver = [] {
    H5FD_class_t c{};
#if H5_VERSION_GE(1, 13, 1)
    c.version = H5FD_CLASS_VERSION;
    c.value = static_cast<H5FD_class_value_t>(490);
#endif
    c.name = "jamscape storage";
    c.maxaddr = HADDR_MAX / 2;
    c.fc_degree = H5F_CLOSE_STRONG;  // closing reaches the storage whatever is still open inside
    c.fapl_size = sizeof(Info);
    c.open = open_file;
    c.close = [](H5FD_t* file) -> herr_t {
      delete ours(file);
      return 0;
    };
    c.query = [](const H5FD_t*, unsigned long* flags) -> herr_t {
      *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
               H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
      return 0;
    };
    c.get_eoa = [](const H5FD_t* file, H5FD_mem_t) { return ours(file)->end_of_allocation; };
    c.set_eoa = [](H5FD_t* file, H5FD_mem_t, haddr_t address) -> herr_t {
      ours(file)->end_of_allocation = address;
      return 0;
    };
    c.get_eof = [](const H5FD_t* file, H5FD_mem_t) -> haddr_t { return ours(file)->storage->size(); };
    c.read = [](H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, void* out) {
      return guarded([&] { ours(file)->storage->read(address, size, static_cast<char*>(out)); });
    };
    c.write = [](H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, const void* bytes) {
      return guarded([&] { ours(file)->storage->write(address, size, static_cast<const char*>(bytes)); });
    };
    c.truncate = [](H5FD_t* file, hid_t, hbool_t) {
      return guarded([&] {
        if (ours(file)->storage->size() != ours(file)->end_of_allocation)
          ours(file)->storage->resize(ours(file)->end_of_allocation);
      });
    };
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(map), std::end(map), c.fl_map);
    return c;
  }();
  return driver;
}

}  // namespace

void use_storage(hid_t access_list, Storage& storage) {
  static const hid_t driver = H5FDregister(&driver_class());
  const Info info{&storage};
  H5Pset_driver(access_list, driver, &info);
}

}  // namespace jam::hdf5
