#include "jamscape/io/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "jamscape/base/error.hpp"
#include "jamscape/io/compressed.hpp"
#include "jamscape/io/number_text.hpp"

namespace jam {
namespace {

/// What an error shows of a field: not all of a long one.
std::string shown(std::string_view text) {
  return text.size() <= 40 ? std::string(text) : std::string(text.substr(0, 37)) + "...";
}

bool needs_quotes(std::string_view text, bool only_column) {
  if (text.empty()) return only_column;  // a line with nothing on it would be skipped
  return text.find_first_of(",\"\r\n") != std::string_view::npos || trimmed(text).size() != text.size() ||
         text[0] == '#' || parse_double(text).has_value();
}

void put(std::string& out, std::string_view text, bool only_column) {
  if (!needs_quotes(text, only_column)) {
    out += text;
    return;
  }
  out += '"';
  for (char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

}  // namespace

/// Walks through the text once.
class CsvFile::Scanner {
 public:
  explicit Scanner(CsvFile& csv) : csv_(csv), now_(csv.text_->data()), end_(now_ + csv.text_->size()) {
    if (csv.text_->starts_with("\xef\xbb\xbf")) now_ += 3;  // the mark of UTF-8 that spreadsheets write
  }

  void scan() {
    while (read_metadata()) {
    }
    skip_blank_lines();
    if (now_ == end_)
      throw data_error("the file has no header row", csv_.file_,
                       "its first row must name the columns, such as i,j,force");
    read_header();
    for (skip_blank_lines(); now_ != end_; skip_blank_lines()) read_row();
  }

 private:
  bool read_metadata() {
    skip_blank_lines();
    if (now_ == end_ || *now_ != '#') return false;
    const char* stop = std::find(now_, end_, '\n');
    std::string_view line(now_ + 1, static_cast<std::size_t>(stop - now_ - 1));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (const auto colon = line.find(':'); colon != std::string_view::npos)
      csv_.metadata_.emplace_back(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
    now_ = stop == end_ ? end_ : stop + 1;
    return true;
  }

  void skip_blank_lines() {
    while (now_ != end_) {
      const char* next = now_;
      while (next != end_ && (*next == ' ' || *next == '\t' || *next == '\r')) ++next;
      if (next != end_ && *next != '\n') return;
      now_ = next == end_ ? end_ : next + 1;
    }
  }

  void read_header() {
    std::vector<Field> names;
    while (read_field(names)) {
    }
    for (const Field& name : names) {
      if (std::find(csv_.columns_.begin(), csv_.columns_.end(), trimmed(name.text)) != csv_.columns_.end())
        throw data_error(fmt::format("the column '{}' stands twice in the header", shown(trimmed(name.text))),
                         csv_.place_of(name.start),
                         parse_double(name.text) ? "the first row holds numbers: put a row of names above it"
                                                 : "give each column a name of its own");
      csv_.columns_.emplace_back(trimmed(name.text));
    }
  }

  void read_row() {
    const char* start = now_;
    const std::size_t before = csv_.fields_.size();
    while (read_field(csv_.fields_)) {
    }
    if (const std::size_t got = csv_.fields_.size() - before; got != csv_.columns_.size())
      throw data_error(fmt::format("a row has {} field{}, the header names {} columns: '{}'", got, got == 1 ? "" : "s",
                                   csv_.columns_.size(), shown({start, line_end(start)})),
                       csv_.place_of(start),
                       now_ == end_ ? "the file may have been cut short" : "check the commas and quotes of this row");
  }

  std::size_t line_end(const char* start) const {
    const std::string_view rest(start, static_cast<std::size_t>(end_ - start));
    return std::min(rest.size(), rest.find_first_of("\r\n"));
  }

  /// Reads a field and what ends it; false when that was the end of the row.
  bool read_field(std::vector<Field>& out) {
    const char* start = now_;
    while (now_ != end_ && (*now_ == ' ' || *now_ == '\t')) ++now_;
    if (now_ != end_ && *now_ == '"') {
      out.push_back({quoted(), start, true});
    } else {
      now_ = start;
      while (now_ != end_ && *now_ != ',' && *now_ != '\n') ++now_;
      std::string_view text(start, static_cast<std::size_t>(now_ - start));
      if (text.ends_with('\r') && (now_ == end_ || *now_ == '\n')) text.remove_suffix(1);
      out.push_back({trimmed(text), start, false});
    }
    if (now_ == end_) return false;
    return *now_++ == ',';
  }

  std::string_view quoted() {
    const char* start = now_++;
    const char* text = now_;
    bool doubled = false;
    while (true) {
      now_ = std::find(now_, end_, '"');
      if (now_ == end_)
        throw data_error(fmt::format("a quote is opened but never closed: '{}'", shown({start, line_end(start)})),
                         csv_.place_of(start), "a quote inside a quoted field is written twice: \"\"");
      if (now_ + 1 == end_ || now_[1] != '"') break;
      doubled = true;
      now_ += 2;
    }
    std::string_view inside(text, static_cast<std::size_t>(now_ - text));
    ++now_;
    while (now_ != end_ && (*now_ == ' ' || *now_ == '\t' || *now_ == '\r')) ++now_;
    if (now_ != end_ && *now_ != ',' && *now_ != '\n')
      throw data_error(fmt::format("text follows a closing quote: '{}'", shown({start, line_end(start)})),
                       csv_.place_of(now_), "a quote inside a quoted field is written twice: \"\"");
    if (!doubled) return inside;
    std::string& single = csv_.unquoted_->emplace_back();
    for (std::size_t k = 0; k < inside.size(); ++k) {
      single += inside[k];
      if (inside[k] == '"') ++k;
    }
    return single;
  }

  CsvFile& csv_;
  const char* now_;
  const char* end_;
};

CsvFile CsvFile::read(const std::filesystem::path& path) { return parse(read_any_text(path), path.string()); }

CsvFile CsvFile::parse(std::string text, std::string file) {
  CsvFile csv;
  csv.file_ = std::move(file);
  csv.text_ = std::make_shared<const std::string>(std::move(text));
  csv.unquoted_ = std::make_shared<std::deque<std::string>>();
  Scanner(csv).scan();
  return csv;
}

std::string CsvFile::place_of(const char* position) const {
  const char* start = text_->data();
  const auto line = 1 + std::count(start, position, '\n');
  const std::string_view before(start, static_cast<std::size_t>(position - start));
  const auto newline = before.rfind('\n');
  const auto column = newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
  return fmt::format("{}:{}:{}", file_, line, column);
}

std::string CsvFile::place(std::size_t row, std::size_t column) const { return place_of(at(row, column).start); }

std::vector<double> CsvFile::numbers(std::size_t column) const {
  std::vector<double> values(rows(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < values.size(); ++row) {
    const std::string_view text = trimmed(field(row, column));
    if (text.empty()) continue;
    const auto value = parse_double(text);
    if (!value)
      throw data_error(fmt::format("'{}' in column '{}' is no number", shown(text), columns_[column]),
                       place(row, column), "numbers have a decimal point and no thousands separators");
    values[row] = *value;
  }
  return values;
}

std::vector<std::int64_t> CsvFile::integers(std::size_t column) const {
  std::vector<std::int64_t> values(rows());
  for (std::size_t row = 0; row < values.size(); ++row) {
    const std::string_view text = field(row, column);
    auto value = parse_integer(text);
    if (const auto real = parse_double(text); !value && real && std::floor(*real) == *real && std::abs(*real) < 9e15)
      value = static_cast<std::int64_t>(*real);  // 3.0, as spreadsheets write it
    if (!value)
      throw data_error(fmt::format("'{}' in column '{}' is no integer", shown(text), columns_[column]),
                       place(row, column));
    values[row] = *value;
  }
  return values;
}

Table CsvFile::table() const {
  Table table;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    bool integers = true, numbers = true, all_empty = rows() > 0;
    for (std::size_t r = 0; r < rows() && numbers; ++r) {
      const Field& f = at(r, c);
      if (!f.text.empty()) all_empty = false;
      if (integers && !f.quoted && parse_integer(f.text)) continue;
      integers = false;
      numbers = !f.quoted && (f.text.empty() || parse_double(f.text));
    }
    if (integers && rows() > 0) {
      table.add(columns_[c], this->integers(c));
    } else if (numbers && !all_empty) {
      table.add(columns_[c], this->numbers(c));
    } else {
      std::vector<std::string> text;
      for (std::size_t r = 0; r < rows(); ++r) text.emplace_back(field(r, c));
      table.add(columns_[c], std::move(text));
    }
  }
  return table;
}

Table read_csv(const std::filesystem::path& path) { return CsvFile::read(path).table(); }

std::string to_csv(const Table& table, const CsvMetadata& metadata) {
  const bool only = table.columns.size() == 1;
  std::string out;
  for (const auto& [key, value] : metadata) {
    std::string line = fmt::format("# {}: {}", key, value);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    out += line + '\n';
  }
  for (const Column& column : table.columns) {
    if (&column != &table.columns.front()) out += ',';
    put(out, column.name, only);
    if (column.size() != table.rows())
      throw data_error(fmt::format("column '{}' has {} entries where '{}' has {}", column.name, column.size(),
                                   table.columns.front().name, table.rows()));
  }
  out += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const Column& column : table.columns) {
      if (&column != &table.columns.front()) out += ',';
      if (const auto* numbers = std::get_if<std::vector<double>>(&column.values))
        out += to_text((*numbers)[row]);
      else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values))
        fmt::format_to(std::back_inserter(out), "{}", (*integers)[row]);
      else
        put(out, std::get<std::vector<std::string>>(column.values)[row], only);
    }
    out += '\n';
  }
  return out;
}

void write_csv(const std::filesystem::path& path, const Table& table, const CsvMetadata& metadata) {
  write_any_text(path, to_csv(table, metadata));
}

}  // namespace jam
