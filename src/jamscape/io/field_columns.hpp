// Fields of a packing (packing/fields.hpp) as columns of tables: one column for each component.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "jamscape/base/table.hpp"
#include "jamscape/io/vector_columns.hpp"
#include "jamscape/packing/fields.hpp"

namespace jam {

/// The names that the columns of a field may have, component by component, the one that is written first.
std::vector<ColumnNames> column_names(const FieldText& field, int dimension);

/// The numbers of one component; throws a data error where one is not finite.
std::vector<double> read_component(const CsvFile& csv, std::size_t column, double);
/// Integers; throws a data error where one is out of range.
template <class N>
std::vector<N> read_component(const CsvFile& csv, std::size_t column, N);

/// The values, zero where a component is not stored; no value without columns. Throws a data error where a component is
/// missing.
template <class T>
std::optional<std::vector<T>> read_field(const CsvFile& csv, const FieldText& field, int dimension) {
  const std::vector<ColumnNames> names = column_names(field, dimension);
  if (!find_column(csv, names[0])) {
    for (const ColumnNames& other : names)
      if (const auto there = find_column(csv, other))
        need_column(csv, names[0], "it goes with '" + csv.columns()[*there] + "'");
    return {};
  }
  std::vector<T> values(csv.rows(), T{});
  const int first = components(field.shape, dimension).first;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto numbers =
        read_component(csv, need_column(csv, names[k], "it goes with '" + names[0][0] + "'"), Number<T>{});
    for (std::size_t row = 0; row < numbers.size(); ++row)
      component(values[row], first + static_cast<int>(k)) = numbers[row];
  }
  return values;
}

template <class T>
void add_field(Table& table, const std::vector<T>& values, const FieldText& field, int dimension) {
  const std::vector<ColumnNames> names = column_names(field, dimension);
  const int first = components(field.shape, dimension).first;
  using Cell = std::conditional_t<std::is_integral_v<Number<T>>, std::int64_t, double>;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<Cell> numbers;
    numbers.reserve(values.size());
    for (const T& value : values) numbers.push_back(component(value, first + static_cast<int>(k)));
    table.add(names[k][0], std::move(numbers));
  }
}

}  // namespace jam
