// Vectors in tables: one column for each component.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "jamscape/geometry/vec.hpp"
#include "jamscape/io/column_names.hpp"

namespace jam {

/// The names of the columns of x, y and z.
using VectorNames = std::array<ColumnNames, 3>;

/// The vectors, z = 0 in two dimensions; no value when there is no column of them. Throws a data error when a component
/// is missing or not finite.
std::optional<std::vector<Vec3>> read_vectors(const CsvFile& csv, const VectorNames& names, int dimension);

/// Throws a data error where a column of z components holds anything but 0.
void refuse_out_of_plane(const CsvFile& csv, const ColumnNames& names);

/// Numbers of which all must be finite.
std::vector<double> read_finite(const CsvFile& csv, std::size_t column);

void add_vectors(Table& table, const std::array<std::string, 3>& names, const std::vector<Vec3>& vectors,
                 int dimension);

/// Three numbers, separated by blanks, from `text`; no value when it holds anything else.
std::optional<std::vector<double>> parse_numbers(std::string_view text, std::size_t count);
std::string to_text(const Vec3& v);

}  // namespace jam
