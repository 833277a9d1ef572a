#include "jamscape/io/plain_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "jamscape/base/error.hpp"
#include "jamscape/io/compressed.hpp"
#include "jamscape/io/number_text.hpp"

namespace jam {
namespace {

enum class Order { low_first, high_first };

void put_utf8(std::string& out, std::uint32_t code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | code >> 6);
    out += static_cast<char>(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    out += static_cast<char>(0xe0 | code >> 12);
    out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
    out += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    out += static_cast<char>(0xf0 | code >> 18);
    out += static_cast<char>(0x80 | (code >> 12 & 0x3f));
    out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
    out += static_cast<char>(0x80 | (code & 0x3f));
  }
}

std::string from_utf16(std::string_view bytes, Order order, const std::string& file) {
  if (bytes.size() % 2 != 0)
    throw data_error("the text is UTF-16 and ends in the middle of a letter", file,
                     "the file may have been cut short; save it as UTF-8");
  const auto unit = [&](std::size_t at) {
    const auto a = static_cast<unsigned char>(bytes[at]), b = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<std::uint32_t>(order == Order::low_first ? a | b << 8 : a << 8 | b);
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    const bool high = code >= 0xd800 && code < 0xdc00;
    if (high && at + 2 < bytes.size() && unit(at + 2) >= 0xdc00 && unit(at + 2) < 0xe000) {
      code = 0x10000 + ((code - 0xd800) << 10) + (unit(at + 2) - 0xdc00);
      at += 2;
    } else if (code >= 0xd800 && code < 0xe000) {
      throw data_error("the text looks like UTF-16 and is damaged", file, "save it as UTF-8");
    }
    put_utf8(out, code);
  }
  return out;
}

/// Without a mark UTF-16 shows by the zeros beside its digits and commas.
std::optional<Order> unmarked_utf16(std::string_view text) {
  const std::size_t looked = std::min<std::size_t>(text.size(), 1024) / 2 * 2;
  std::array<std::size_t, 2> zeros{};
  for (std::size_t k = 0; k < looked; ++k) zeros[k % 2] += text[k] == '\0';
  if (zeros[1] * 4 > looked && zeros[0] == 0) return Order::low_first;
  if (zeros[0] * 4 > looked && zeros[1] == 0) return Order::high_first;
  return {};
}

/// The number of fields of a line; separators inside quotes do not count.
std::size_t count_fields(std::string_view line, char separator) {
  std::size_t fields = 1;
  bool quoted = false;
  line = trimmed(line);
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') quoted = !quoted;
    if (quoted) continue;
    if (separator != ' ')
      fields += line[k] == separator;
    else
      fields += (line[k] == ' ' || line[k] == '\t') && line[k - 1] != ' ' && line[k - 1] != '\t';
  }
  return fields;
}

}  // namespace

std::string plain_text(std::string text, const std::string& file) {
  if (text.starts_with("\xff\xfe"))
    text = from_utf16(std::string_view(text).substr(2), Order::low_first, file);
  else if (text.starts_with("\xfe\xff"))
    text = from_utf16(std::string_view(text).substr(2), Order::high_first, file);
  else if (text.starts_with("\xef\xbb\xbf"))
    text.erase(0, 3);
  else if (const auto order = unmarked_utf16(text))
    text = from_utf16(text, *order, file);
  if (const auto zero = text.find('\0'); zero != std::string::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw data_error(fmt::format("the file is no text: byte {} is zero", zero + 1), fmt::format("{}:{}:1", file, line),
                     "tables and networks are read from text (CSV), plain, .gz or .zst");
  }
  if (text.find('\r') != std::string::npos) {
    for (std::size_t k = 0; k < text.size(); ++k)
      if (text[k] == '\r' && (k + 1 == text.size() || (text[k + 1] != '\n' && text[k + 1] != '\r'))) text[k] = '\n';
  }
  return text;
}

std::string read_plain_text(const std::filesystem::path& path) {
  return plain_text(read_any_text(path), path.string());
}

Separator find_separator(std::string_view header, std::string_view first_row) {
  std::size_t most = 1;
  Separator best;
  for (const char candidate : {',', ';', '\t', '|', ' '}) {
    const std::size_t names = count_fields(header, candidate);
    if (candidate == ' ' && most > 1) break;
    if (names > most && (trimmed(first_row).empty() || count_fields(first_row, candidate) == names)) {
      most = names;
      best.character = candidate;
    }
  }
  if (most > 1) return best;
  for (const char candidate : {',', ';', '\t', '|'})  // a row that does not fit is named as such later
    if (const std::size_t names = count_fields(header, candidate); names > most) {
      most = names;
      best.character = candidate;
    }
  return best;
}

std::optional<Separator> stated_separator(std::string_view line) {
  if (line.size() != 5 || !line.starts_with("sep=")) return {};
  return Separator{line[4], true};
}

bool has_decimal_comma(std::string_view text) {
  const auto comma = text.find(',');
  if (comma == std::string_view::npos || text.find(',', comma + 1) != std::string_view::npos ||
      text.find('.') != std::string_view::npos)
    return false;
  std::string point(text);
  point[comma] = '.';
  return parse_double(point).has_value();
}

}  // namespace jam
