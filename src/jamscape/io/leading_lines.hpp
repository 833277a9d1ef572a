// The `# key: value` lines of a table: found by name, and nothing in them passed over in silence.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/io/csv.hpp"

namespace jam {

/// Keys that a table may have, and those that belong into the table beside it.
struct KnownKeys {
  std::vector<std::string> here;
  std::vector<std::string> once;           ///< of those here: what stands there once
  std::vector<std::string> consequential;  ///< of all: what must not be missed for a letter
  std::vector<std::string> elsewhere;
  std::string other_table;
};

class LeadingLines {
 public:
  /// Appends a note on keys nobody reads. Throws a data error for a key or a line without a colon that resembles one of
  /// consequence, one that belongs into the other table, a usual name for something that goes by another here (`box`),
  /// and a key given twice.
  LeadingLines(const CsvFile& csv, const KnownKeys& known, std::vector<std::string>& notes);

  const CsvRemark* find(std::string_view key) const;
  std::vector<const CsvRemark*> all(std::string_view key) const;
  /// As many numbers as asked for; throws where the line holds something else.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count) const;
  double number(std::string_view key, double otherwise) const;

 private:
  const CsvFile& csv_;
};

}  // namespace jam
