// What text from anywhere is turned into before anything reads it: UTF-8 without a mark, lines that end in \n; and how
// a table of it is written: what stands between its columns, and what a decimal point looks like. The one place that
// decides.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace jam {

/// A file's text, also from gzip or zstd. Throws a data error for what is no text.
std::string read_plain_text(const std::filesystem::path& path);

/// UTF-16 with or without a mark becomes UTF-8, the mark of UTF-8 goes, and \r alone becomes \n. Throws a data error
/// that names `file` for bytes that no text has.
std::string plain_text(std::string text, const std::string& file);

/// What stands between the columns of a table.
struct Separator {
  char character = ',';  ///< ' ' stands for any number of blanks and tabs
  bool stated = false;   ///< by a first line `sep=;`, which spreadsheets write
};

/// Decided by the header and the row below it: of commas, semicolons, tabs, bars and blanks the one that gives the most
/// columns, the same number in both.
Separator find_separator(std::string_view header, std::string_view first_row);

/// `sep=;` as the first line of a file.
std::optional<Separator> stated_separator(std::string_view line);

/// A number with a decimal comma, as 2,5 or -1,5E-3.
bool has_decimal_comma(std::string_view text);

}  // namespace jam
