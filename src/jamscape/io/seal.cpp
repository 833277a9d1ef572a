#include "jamscape/io/seal.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cstdint>
#include <cstring>

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

}  // namespace jam
