#include "jamscape/io/vector_columns.hpp"

#include <fmt/format.h>

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/io/number_text.hpp"

namespace jam {

std::vector<double> read_finite(const CsvFile& csv, std::size_t column) {
  std::vector<double> values = csv.numbers(column);
  for (std::size_t row = 0; row < values.size(); ++row)
    if (!std::isfinite(values[row]))
      throw data_error(
          fmt::format("'{}' in column '{}' is no finite number", csv.field(row, column), csv.columns()[column]),
          csv.place(row, column), "fill it in, or remove the row");
  return values;
}

std::optional<std::vector<Vec3>> read_vectors(const CsvFile& csv, const VectorNames& names, int dimension) {
  if (!find_column(csv, names[0])) {
    for (int k = 1; k < dimension; ++k)
      if (const auto other = find_column(csv, names[static_cast<std::size_t>(k)]))
        need_column(csv, names[0], fmt::format("it goes with '{}'", csv.columns()[*other]));
    return {};
  }
  std::vector<Vec3> vectors(csv.rows(), Vec3{});
  for (int k = 0; k < dimension; ++k) {
    const auto& name = names[static_cast<std::size_t>(k)];
    const auto values = read_finite(csv, need_column(csv, name, fmt::format("it goes with '{}'", names[0][0])));
    for (std::size_t row = 0; row < values.size(); ++row) vectors[row][k] = values[row];
  }
  return vectors;
}

void refuse_out_of_plane(const CsvFile& csv, const ColumnNames& names) {
  const auto column = find_column(csv, names);
  if (!column) return;
  const std::vector<double> values = read_finite(csv, *column);
  for (std::size_t row = 0; row < values.size(); ++row)
    if (values[row] != 0)
      throw data_error(fmt::format("'{}' in column '{}' leaves the plane of a two-dimensional packing",
                                   csv.field(row, *column), csv.columns()[*column]),
                       csv.place(row, *column),
                       "a layer of spheres has the line '# dimension: 3' in its table of particles");
}

void add_vectors(Table& table, const std::array<std::string, 3>& names, const std::vector<Vec3>& vectors,
                 int dimension) {
  for (int k = 0; k < dimension; ++k) {
    std::vector<double> values;
    for (const Vec3& v : vectors) values.push_back(v[k]);
    table.add(names[static_cast<std::size_t>(k)], std::move(values));
  }
}

std::optional<std::vector<double>> parse_numbers(std::string_view text, std::size_t count) {
  std::vector<double> values;
  for (text = trimmed(text); !text.empty();) {
    const auto end = std::min(text.size(), text.find_first_of(" \t"));
    const auto value = parse_double(text.substr(0, end));
    if (!value || !std::isfinite(*value)) return {};
    values.push_back(*value);
    text = trimmed(text.substr(end));
  }
  if (values.size() != count) return {};
  return values;
}

std::string to_text(const Vec3& v) { return to_text(v[0]) + ' ' + to_text(v[1]) + ' ' + to_text(v[2]); }

}  // namespace jam
