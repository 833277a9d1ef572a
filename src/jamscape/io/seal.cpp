#include "jamscape/io/seal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

static_assert(std::endian::native == std::endian::little, "seals are written in native order");

struct Seal {
  char magic[8] = {'J', 'A', 'M', 'S', 'E', 'A', 'L', '1'};
  std::uint64_t size = 0;
  std::uint64_t crc = 0;
};
static_assert(sizeof(Seal) == 24);

Seal seal_of(const char* bytes, std::size_t size) {
  Seal made;
  made.size = size;
  made.crc = ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes), size);
  return made;
}

/// A file to be read, and written at its end.
class Bytes {
 public:
  Bytes(const std::filesystem::path& path, int flags)
      : path_(path), descriptor_(::open(path.c_str(), flags | O_CLOEXEC)) {
    if (descriptor_ < 0) fail("read", errno);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  ~Bytes() { ::close(descriptor_); }

  [[noreturn]] void fail(const char* verb, int code) const {
    throw data_error(fmt::format("cannot {}: {}", verb, std::strerror(code)), path_.string(),
                     code == ENOSPC || code == EDQUOT ? "make room on the disk, or write elsewhere" : "");
  }

  std::uint64_t size() const {
    const off_t end = ::lseek(descriptor_, 0, SEEK_END);
    if (end < 0) fail("read", errno);
    return static_cast<std::uint64_t>(end);
  }

  /// How many bytes there were, fewer than asked for at the end of the file only.
  std::size_t read(std::uint64_t address, char* out, std::size_t wanted) const {
    std::size_t done = 0;
    while (done < wanted) {
      const ssize_t n = ::pread(descriptor_, out + done, wanted - done, static_cast<off_t>(address + done));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail("read", errno);
      if (n == 0) break;
      done += static_cast<std::size_t>(n);
    }
    return done;
  }

  void append(const char* bytes, std::size_t size) const {
    for (std::uint64_t end = this->size(), done = 0; done < size;) {
      const ssize_t n = ::pwrite(descriptor_, bytes + done, size - done, static_cast<off_t>(end + done));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail("write", errno);
      done += static_cast<std::uint64_t>(n);
    }
  }

  /// Of the first `size` bytes.
  Seal seal(std::uint64_t size) const {
    constexpr std::size_t piece = 1 << 20;
    const auto buffer = std::make_unique<char[]>(piece);
    Seal made;
    made.size = size;
    for (std::uint64_t at = 0; at < size;) {
      const std::size_t n = read(at, buffer.get(), static_cast<std::size_t>(std::min<std::uint64_t>(piece, size - at)));
      if (n == 0) break;  // it became shorter meanwhile: the sum will not fit
      made.crc = ::crc32_z(made.crc, reinterpret_cast<const Bytef*>(buffer.get()), n);
      at += n;
    }
    return made;
  }

  /// The last bytes, taken for a seal; one of another kind when they are none.
  Seal last() const {
    Seal found{.magic = {}};
    if (const std::uint64_t all = size(); all >= sizeof found)
      read(all - sizeof found, reinterpret_cast<char*>(&found), sizeof found);
    return found;
  }

 private:
  std::filesystem::path path_;
  int descriptor_;
};

bool is_seal(const Seal& seal, std::uint64_t file_size) {
  return std::memcmp(seal.magic, Seal{}.magic, sizeof seal.magic) == 0 && seal.size + sizeof seal == file_size;
}

constexpr const char* advice = "remove it: it is made anew when its task runs again";

}  // namespace

std::string seal(std::string bytes) {
  const Seal made = seal_of(bytes.data(), bytes.size());
  bytes.append(reinterpret_cast<const char*>(&made), sizeof made);
  return bytes;
}

std::string unseal(std::string bytes, const std::string& file) {
  Seal found{.magic = {}};
  if (bytes.size() >= sizeof found)
    std::memcpy(static_cast<void*>(&found), bytes.data() + bytes.size() - sizeof found, sizeof found);
  if (std::memcmp(found.magic, Seal{}.magic, sizeof found.magic) != 0)
    throw data_error(
        fmt::format("the file is truncated or of another kind: its {} bytes do not end in a seal", bytes.size()), file,
        advice);
  bytes.resize(bytes.size() - sizeof found);
  const Seal right = seal_of(bytes.data(), bytes.size());
  if (found.size != right.size || found.crc != right.crc)
    throw data_error("the file is damaged: its content does not fit its checksum", file, advice);
  return bytes;
}

void seal_file(const std::filesystem::path& path) {
  const Bytes file(path, O_RDWR);
  const Seal made = file.seal(file.size());
  file.append(reinterpret_cast<const char*>(&made), sizeof made);
}

bool ends_in_seal(const std::filesystem::path& path) {
  const Bytes file(path, O_RDONLY);
  return is_seal(file.last(), file.size());
}

bool seal_fits(const std::filesystem::path& path) {
  const Bytes file(path, O_RDONLY);
  const Seal found = file.last();
  return is_seal(found, file.size()) && file.seal(found.size).crc == found.crc;
}

}  // namespace jam
