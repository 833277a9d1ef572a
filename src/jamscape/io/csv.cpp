#include "jamscape/io/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "jamscape/base/error.hpp"
#include "jamscape/base/printable.hpp"
#include "jamscape/io/compressed.hpp"
#include "jamscape/io/number_text.hpp"

namespace jam {
namespace {

/// What an error shows of a field: not all of a long one, cut between letters.
std::string shown(std::string_view text) {
  if (text.size() <= 40) return printable(text, LineEnds::escape);
  std::size_t end = 37;
  while (end > 34 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return printable(text.substr(0, end), LineEnds::escape) + "...";
}

bool needs_quotes(std::string_view text, bool first_column) {
  if (text.empty()) return first_column;  // a line with nothing on it would be skipped
  return text.find_first_of(",;|\t\"\r\n") != std::string_view::npos || trimmed(text).size() != text.size() ||
         text[0] == '#' || text.starts_with("sep=") || parse_double(text).has_value();
}

void put(std::string& out, std::string_view text, bool first_column) {
  if (!needs_quotes(text, first_column)) {
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
  explicit Scanner(CsvFile& csv) : csv_(csv), now_(csv.text_->data()), end_(now_ + csv.text_->size()) {}

  void scan() {
    skip_remarks();
    if (const auto stated = stated_separator(line_at(now_))) {
      csv_.separator_ = *stated;
      now_ += line_at(now_).size();
      skip_remarks();
    }
    if (now_ == end_)
      throw data_error("the file has no header row", csv_.file_,
                       "its first row must name the columns, such as i,j,force");
    if (!csv_.separator_.stated) csv_.separator_ = find_separator(line_at(now_), line_at(next_row(now_)));
    separator_ = csv_.separator_.character;
    read_header();
    for (skip_remarks(); now_ != end_; skip_remarks()) read_row();
    refuse_nameless();
  }

 private:
  /// The first column may number the rows; any other without a name is what a decimal comma or a lost name leaves.
  void refuse_nameless() const {
    for (std::size_t c = 1; c < csv_.columns_.size(); ++c)
      for (std::size_t r = 0; csv_.columns_[c].empty() && r < csv_.rows(); ++r)
        if (!csv_.field(r, c).empty())
          throw data_error(fmt::format("a column without a name holds '{}'", shown(csv_.field(r, c))), csv_.place(r, c),
                           "name the column, or empty it; where numbers have decimal commas, put semicolons between "
                           "the columns");
  }

  void skip_remarks() {
    for (skip_blank_lines(); now_ != end_ && *now_ == '#'; skip_blank_lines()) read_remark();
  }

  void read_remark() {
    const char* stop = std::find(now_, end_, '\n');
    std::string_view line(now_ + 1, static_cast<std::size_t>(stop - now_ - 1));
    while (line.ends_with('\r')) line.remove_suffix(1);
    while (!csv_.separator_.stated && line.ends_with(',')) line.remove_suffix(1);  // spreadsheets fill the line up
    while (line.ends_with(';')) line.remove_suffix(1);
    const auto colon = line.find(':');
    const bool keyed = colon != std::string_view::npos;
    const std::string_view key = keyed ? trimmed(line.substr(0, colon)) : std::string_view{};
    const std::string_view value = trimmed(keyed ? line.substr(colon + 1) : line);
    csv_.remarks_.push_back({std::string(key), std::string(value), place_of_remark()});
    now_ = stop == end_ ? end_ : stop + 1;
  }

  /// place_of(now_); counts on from the remark before, since there may be many.
  std::string place_of_remark() {
    line_ += static_cast<std::size_t>(std::count(counted_, now_, '\n'));
    counted_ = now_;
    const char* begin = now_;
    while (begin != csv_.text_->data() && begin[-1] != '\n') --begin;
    return fmt::format("{}:{}:{}", csv_.file_, line_, now_ - begin + 1);
  }

  /// The line without what ends it.
  std::string_view line_at(const char* start) const { return {start, line_end(start)}; }

  /// Behind the line that begins at `start`, empty lines and remarks skipped.
  const char* next_row(const char* start) const {
    while (true) {
      start = std::find(start, end_, '\n');
      if (start == end_) return end_;
      ++start;
      const std::string_view line = trimmed(line_at(start));
      if (!line.empty() && line[0] != '#') return start;
    }
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
    csv_.header_line_ = 1 + static_cast<std::size_t>(std::count(csv_.text_->data(), now_, '\n'));
    std::vector<Field> names;
    while (read_field(names)) {
    }
    for (const Field& name : names) {
      if (!trimmed(name.text).empty() &&
          std::find(csv_.columns_.begin(), csv_.columns_.end(), trimmed(name.text)) != csv_.columns_.end())
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
    if (csv_.fields_[before].text.empty() && csv_.columns_.size() > 1 &&
        std::all_of(csv_.fields_.begin() + static_cast<std::ptrdiff_t>(before), csv_.fields_.end(),
                    [](const Field& f) { return f.text.empty() && !f.quoted; }))
      return csv_.fields_.resize(before);
    if (const std::size_t got = csv_.fields_.size() - before; got != csv_.columns_.size())
      throw data_error(fmt::format("a row has {} field{}, the header names {} columns: '{}'", got, got == 1 ? "" : "s",
                                   csv_.columns_.size(), shown({start, line_end(start)})),
                       csv_.place_of(start), row_advice(got));
  }

  std::string row_advice(std::size_t got) const {
    if (got < csv_.columns_.size() && now_ == end_) return "the file may have been cut short";
    if (separator_ != ',') return fmt::format("check the {} and quotes of this row", separators());
    if (got > csv_.columns_.size())
      return "check the commas and quotes of this row; where numbers have decimal commas, write points, or put "
             "semicolons between the columns";
    return "check the commas and quotes of this row";
  }

  const char* separators() const {
    return separator_ == ';' ? "semicolons" : separator_ == '\t' ? "tabs" : separator_ == ' ' ? "blanks" : "separators";
  }

  std::size_t line_end(const char* start) const {
    const std::string_view rest(start, static_cast<std::size_t>(end_ - start));
    return std::min(rest.size(), rest.find_first_of("\r\n"));
  }

  /// Reads a field and what ends it; false when that was the end of the row.
  bool read_field(std::vector<Field>& out) {
    if (separator_ == ' ') skip_blanks();
    const char* start = now_;
    while (now_ != end_ && (*now_ == ' ' || *now_ == '\t') && *now_ != separator_) ++now_;
    if (now_ != end_ && *now_ == '"') {
      out.push_back({quoted(), start, true});
    } else {
      now_ = start;
      while (now_ != end_ && *now_ != '\n' && !separates(*now_)) ++now_;
      std::string_view text(start, static_cast<std::size_t>(now_ - start));
      if (now_ == end_ || *now_ == '\n')
        while (text.ends_with('\r')) text.remove_suffix(1);
      out.push_back({trimmed(text), start, false});
    }
    if (separator_ == ' ') {
      skip_blanks();
      if (now_ != end_ && *now_ == '\r') ++now_;
      if (now_ != end_ && *now_ != '\n') return true;
    }
    if (now_ == end_) return false;
    return *now_++ == separator_;
  }

  bool separates(char c) const { return c == separator_ || (separator_ == ' ' && (c == '\t' || c == '\r')); }

  void skip_blanks() {
    while (now_ != end_ && (*now_ == ' ' || *now_ == '\t')) ++now_;
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
    while (now_ != end_ && !separates(*now_) && (*now_ == ' ' || *now_ == '\t' || *now_ == '\r')) ++now_;
    if (now_ != end_ && !separates(*now_) && *now_ != '\n')
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
  char separator_ = ',';
  const char* now_;
  const char* end_;
  const char* counted_ = now_;  ///< so far there are line_ lines
  std::size_t line_ = 1;
};

CsvFile CsvFile::read(const std::filesystem::path& path) { return parse(read_any_text(path), path.string()); }

CsvFile CsvFile::parse(std::string text, std::string file) {
  CsvFile csv;
  csv.file_ = std::move(file);
  csv.text_ = std::make_shared<const std::string>(plain_text(std::move(text), csv.file_));
  csv.unquoted_ = std::make_shared<std::deque<std::string>>();
  Scanner(csv).scan();
  csv.read_.assign(csv.columns_.size(), 0);
  return csv;
}

CsvMetadata CsvFile::metadata() const {
  CsvMetadata keyed;
  for (const CsvRemark& remark : remarks_)
    if (!remark.key.empty()) keyed.emplace_back(remark.key, remark.value);
  return keyed;
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
  read_[column] = 1;
  bool commas = false;
  std::vector<double> values(rows(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < values.size(); ++row) {
    const std::string_view text = trimmed(field(row, column));
    if (text.empty()) continue;
    auto value = parse_double(text);
    if (!value && separator_.character != ',' && has_decimal_comma(text)) {
      if (!commas) refuse_points(row, column);
      commas = true;
      std::string point(text);
      std::replace(point.begin(), point.end(), ',', '.');
      value = parse_double(point);
    }
    if (!value)
      throw data_error(fmt::format("'{}' in column '{}' is no number", shown(text), shown(columns_[column])),
                       place(row, column), number_advice(text));
    values[row] = *value;
  }
  return values;
}

/// A comma is a decimal comma where no number has a point: in 1,234 beside 0.5 it may part thousands.
void CsvFile::refuse_points(std::size_t row, std::size_t column) const {
  for (std::size_t r = 0; r < rows(); ++r)
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::string_view text = field(r, c);
      if (text.find('.') == std::string_view::npos || !parse_double(text)) continue;
      throw data_error(fmt::format("'{}' in column '{}' has a comma, but '{}' at {} a decimal point",
                                   shown(field(row, column)), shown(columns_[column]), shown(text), place(r, c)),
                       place(row, column), "write all numbers alike, without thousands separators");
    }
}

std::string CsvFile::number_advice(std::string_view text) const {
  if (has_decimal_comma(text))
    return "write a decimal point, or put semicolons between the columns of a table with decimal commas";
  return "numbers have a decimal point and no thousands separators";
}

std::vector<std::int64_t> CsvFile::integers(std::size_t column) const {
  read_[column] = 1;
  std::vector<std::int64_t> values(rows());
  for (std::size_t row = 0; row < values.size(); ++row) {
    const std::string_view text = field(row, column);
    auto value = parse_integer(text);
    if (!value) value = parse_whole_number(text);
    // 3,0 of a table of decimal commas; 1,000 may be a thousand
    if (!value && separator_.character != ',' && has_decimal_comma(text) && text.size() - text.find(',') != 4) {
      refuse_points(row, column);
      std::string point(text);
      std::replace(point.begin(), point.end(), ',', '.');
      value = parse_whole_number(point);
    }
    if (!value)
      throw data_error(fmt::format("'{}' in column '{}' is no integer", shown(text), shown(columns_[column])),
                       place(row, column),
                       parse_double(text) && text.find_first_of("eEdD") != std::string_view::npos
                           ? "write all its digits: with an exponent some of them are lost"
                           : "ids and counts are whole numbers without separators of thousands");
    values[row] = *value;
  }
  return values;
}

std::vector<std::string> CsvFile::unread() const {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (read_[c] != 0 || columns_[c].empty()) continue;
    bool empty = true;
    for (std::size_t r = 0; r < rows() && empty; ++r) empty = field(r, c).empty();
    if (!empty) names.push_back(columns_[c]);
  }
  return names;
}

CsvFile CsvFile::with_rows(const std::vector<std::size_t>& rows) const {
  CsvFile out = *this;
  out.fields_.clear();
  out.fields_.reserve(rows.size() * columns_.size());
  for (const std::size_t row : rows)
    for (std::size_t c = 0; c < columns_.size(); ++c) out.fields_.push_back(at(row, c));
  return out;
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
  std::string out;
  for (const auto& [key, value] : metadata) {
    std::string line = fmt::format("# {}: {}", key, value);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    out += line + '\n';
  }
  for (const Column& column : table.columns) {
    if (&column != &table.columns.front()) out += ',';
    put(out, column.name, &column == &table.columns.front());
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
        put(out, std::get<std::vector<std::string>>(column.values)[row], &column == &table.columns.front());
    }
    out += '\n';
  }
  return out;
}

void write_csv(const std::filesystem::path& path, const Table& table, const CsvMetadata& metadata) {
  write_any_text(path, to_csv(table, metadata));
}

}  // namespace jam
