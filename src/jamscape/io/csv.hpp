// Tables as CSV: UTF-8, commas, a header row, RFC 4180 quotes, \n or \r\n, leading `# key: value` lines; plain, gzip or
// zstd. Numbers are read and written the same in every locale and round-trip to the bit. Read are also what
// spreadsheets make of that: UTF-16, a mark in front, \r alone, a line `sep=;`, semicolons, tabs or blanks between
// columns, and there decimal commas (plain_text.hpp decides).
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jamscape/base/table.hpp"
#include "jamscape/io/plain_text.hpp"

namespace jam {

using CsvMetadata = std::vector<std::pair<std::string, std::string>>;

/// A line that begins with #, wherever it stands: `# key: value`, or a remark without a colon.
struct CsvRemark {
  std::string key, value;  ///< a remark: all of it in `value`
  std::string place;
};

/// A table as it stands in a file: fields as text, each with its place, turned into numbers on demand. Errors are data
/// errors at file:line:column that show the offending text.
class CsvFile {
 public:
  /// Throws for a missing header, a row with more or fewer fields than the header, a quote that is not closed, a column
  /// named twice. Blank lines are skipped, and rows whose fields are all empty.
  static CsvFile read(const std::filesystem::path& path);
  static CsvFile parse(std::string text, std::string file);

  const std::string& file() const { return file_; }
  const std::vector<CsvRemark>& remarks() const { return remarks_; }
  /// Those of the form `# key: value`, as to_csv() takes them.
  CsvMetadata metadata() const;
  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t rows() const { return columns_.empty() ? 0 : fields_.size() / columns_.size(); }

  std::string_view field(std::size_t row, std::size_t column) const { return at(row, column).text; }
  /// file:line:column of a field, lines and columns from 1.
  std::string place(std::size_t row, std::size_t column) const;

  std::string place_of_header() const { return file_ + ":" + std::to_string(header_line_) + ":1"; }

  /// An empty field is nan. Throws where some numbers of the file have a decimal point and others a decimal comma.
  std::vector<double> numbers(std::size_t column) const;
  /// Every digit of it: 7.0 is one, but not 1.5, and not 7.2e16, whose last digits are lost.
  std::vector<std::int64_t> integers(std::size_t column) const;
  /// The names of the columns that numbers() and integers() were not asked for so far, but empty ones.
  std::vector<std::string> unread() const;
  /// Only these rows, in this order.
  CsvFile with_rows(const std::vector<std::size_t>& rows) const;
  /// Columns by what they hold: integers, numbers (an empty field is nan), or text. A quoted field is text; the columns
  /// of a table without rows are numbers.
  Table table() const;

 private:
  struct Field {
    std::string_view text;
    const char* start;  ///< in the file's text, for its place
    bool quoted;
  };
  class Scanner;

  const Field& at(std::size_t row, std::size_t column) const { return fields_[row * columns_.size() + column]; }
  std::string place_of(const char* position) const;
  void refuse_points(std::size_t row, std::size_t column) const;
  std::string number_advice(std::string_view text) const;

  std::string file_;
  std::shared_ptr<const std::string> text_;  ///< shared, so that a copy's fields stay where they are
  std::shared_ptr<std::deque<std::string>> unquoted_;
  Separator separator_;
  std::size_t header_line_ = 1;
  std::vector<CsvRemark> remarks_;
  std::vector<std::string> columns_;
  std::vector<Field> fields_;       ///< row by row
  mutable std::vector<char> read_;  ///< of each column: whether its values were asked for
};

Table read_csv(const std::filesystem::path& path);

/// Text that would read as a number is quoted. Throws a data error for columns of unequal length.
std::string to_csv(const Table& table, const CsvMetadata& metadata = {});

/// Written aside and renamed; compressed when the path ends in .gz or .zst.
void write_csv(const std::filesystem::path& path, const Table& table, const CsvMetadata& metadata = {});

}  // namespace jam
