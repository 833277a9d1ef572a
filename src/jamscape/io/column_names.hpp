// Columns by any of the names they go by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jamscape/io/csv.hpp"

namespace jam {

/// The names a column may have, the usual one first; capitals do not matter.
using ColumnNames = std::vector<std::string>;

/// In small letters (ASCII).
std::string lower_case(std::string text);

std::optional<std::size_t> find_column(const CsvFile& csv, const ColumnNames& names);

/// Throws a data error that says what there is and which of it may be meant.
std::size_t need_column(const CsvFile& csv, const ColumnNames& names, const std::string& what);

}  // namespace jam
