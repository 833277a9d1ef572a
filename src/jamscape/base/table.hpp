// A table of named columns: what measures return, what CSV files hold, what the report reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace jam {

struct Column {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;

  std::size_t size() const;
};

/// Columns of equal length, in a fixed order.
struct Table {
  std::vector<Column> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  bool has(std::string_view name) const;
  /// Throws a data error naming the columns there are.
  const Column& column(std::string_view name) const;
  /// The column as doubles (integers are converted); throws a data error when it holds text.
  std::vector<double> numbers(std::string_view name) const;

  void add(std::string name, std::vector<double> values) { columns.push_back({std::move(name), std::move(values)}); }
  void add(std::string name, std::vector<std::int64_t> values) {
    columns.push_back({std::move(name), std::move(values)});
  }
  void add(std::string name, std::vector<std::string> values) {
    columns.push_back({std::move(name), std::move(values)});
  }
};

}  // namespace jam
