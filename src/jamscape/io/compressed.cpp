#include "jamscape/io/compressed.hpp"

#include <fmt/format.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"

namespace jam {
namespace {

constexpr int gzip_window = 15 + 16;  // largest window; +16 asks zlib for the gzip wrapper

Error broken(const char* format, const std::string& why, const std::filesystem::path& path) {
  return data_error(fmt::format("the {} data are cut short or damaged: {}", format, why), path.string(),
                    "copy or download the file again");
}

/// zlib counts in 32 bits, so it is fed in pieces.
void feed(z_stream& stream, const std::string& bytes, std::size_t& used) {
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + used));
  stream.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes.size() - used, 1u << 30));
  used += stream.avail_in;
}

std::string gunzip(const std::string& bytes, const std::filesystem::path& path) {
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw broken("gzip", "zlib cannot start", path);
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
  std::string text, buffer(1 << 16, '\0');
  std::size_t used = 0;
  bool whole = false;
  while (true) {
    if (stream.avail_in == 0) {
      if (used == bytes.size()) break;
      feed(stream, bytes, used);
    }
    if (whole) {  // one gzip file may hold several, one behind the other
      inflateReset(&stream);
      whole = false;
    }
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    const int state = inflate(&stream, Z_NO_FLUSH);
    text.append(buffer.data(), buffer.size() - stream.avail_out);
    whole = state == Z_STREAM_END;
    if (state != Z_OK && state != Z_STREAM_END) throw broken("gzip", stream.msg ? stream.msg : "unexpected end", path);
  }
  if (!whole) throw broken("gzip", "unexpected end", path);
  return text;
}

std::string gzip(const std::string& text) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
  std::string bytes, buffer(1 << 16, '\0');
  std::size_t used = 0;
  for (int state = Z_OK; state != Z_STREAM_END;) {
    if (stream.avail_in == 0 && used < text.size()) feed(stream, text, used);
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = deflate(&stream, used == text.size() ? Z_FINISH : Z_NO_FLUSH);
    bytes.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  return bytes;
}

std::string unzstd(const std::string& bytes, const std::filesystem::path& path) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(), ZSTD_freeDStream);
  std::string text, buffer(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t left = 1;  // 0 at the end of a zstd frame
  while (true) {
    ZSTD_outBuffer out{buffer.data(), buffer.size(), 0};
    left = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(left)) throw broken("zstd", ZSTD_getErrorName(left), path);
    text.append(buffer.data(), out.pos);
    if (in.pos == in.size && (left == 0 || out.pos < out.size)) break;
  }
  if (left != 0) throw broken("zstd", "unexpected end", path);
  return text;
}

std::string zstd(const std::string& text) {
  std::string bytes(ZSTD_compressBound(text.size()), '\0');
  const std::size_t size = ZSTD_compress(bytes.data(), bytes.size(), text.data(), text.size(), 3);
  if (ZSTD_isError(size)) throw std::bad_alloc();
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string read_any_text(const std::filesystem::path& path) {
  std::string bytes = read_text(path);
  if (bytes.starts_with("\x1f\x8b")) return gunzip(bytes, path);
  if (bytes.starts_with("\x28\xb5\x2f\xfd")) return unzstd(bytes, path);
  return bytes;
}

void write_any_text(const std::filesystem::path& path, const std::string& text) {
  const std::string ending = path.extension().string();
  write_text(path, ending == ".gz" ? gzip(text) : ending == ".zst" ? zstd(text) : text);
}

}  // namespace jam
