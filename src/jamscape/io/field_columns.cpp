#include "jamscape/io/field_columns.hpp"

#include <fmt/format.h>

#include <sstream>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) out.push_back(part);
  return out;
}

std::string default_columns(const FieldText& field) {
  const std::string name = field.name;
  if (field.shape == FieldShape::scalar) return name;
  if (field.shape == FieldShape::quaternion) return name + "_w " + name + "_x " + name + "_y " + name + "_z";
  return name + "_x " + name + "_y " + name + "_z";
}

}  // namespace

/// An alternative of one word is the single component of a rotation in the plane.
std::vector<ColumnNames> column_names(const FieldText& field, int dimension) {
  const Components stored = components(field.shape, dimension);
  const auto count = static_cast<std::size_t>(stored.count), first = static_cast<std::size_t>(stored.first);
  std::vector<ColumnNames> names(count);
  for (const std::string& alternative : split(field.columns ? field.columns : default_columns(field), '|')) {
    const std::vector<std::string> words = split(alternative, ' ');
    if (words.size() == 1 && count == 1) names[0].push_back(words[0]);
    for (std::size_t k = 0; words.size() > 1 && k < count; ++k) names[k].push_back(words[first + k]);
  }
  return names;
}

std::vector<double> read_component(const CsvFile& csv, std::size_t column, double) { return read_finite(csv, column); }

template <class N>
std::vector<N> read_component(const CsvFile& csv, std::size_t column, N) {
  const auto values = csv.integers(column);
  std::vector<N> numbers(values.size());
  for (std::size_t row = 0; row < values.size(); ++row) {
    numbers[row] = static_cast<N>(values[row]);
    if (static_cast<std::int64_t>(numbers[row]) != values[row])
      throw data_error(fmt::format("{} in column '{}' is out of range", values[row], csv.columns()[column]),
                       csv.place(row, column));
  }
  return numbers;
}
template std::vector<std::int64_t> read_component(const CsvFile&, std::size_t, std::int64_t);
template std::vector<std::int32_t> read_component(const CsvFile&, std::size_t, std::int32_t);

}  // namespace jam
