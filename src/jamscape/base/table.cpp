#include "jamscape/base/table.hpp"

#include "jamscape/base/error.hpp"

namespace jam {

std::size_t Column::size() const {
  return std::visit([](const auto& v) { return v.size(); }, values);
}

bool Table::has(std::string_view name) const {
  for (const Column& c : columns)
    if (c.name == name) return true;
  return false;
}

const Column& Table::column(std::string_view name) const {
  std::string known;
  for (const Column& c : columns) {
    if (c.name == name) return c;
    known += (known.empty() ? "" : ", ") + c.name;
  }
  throw data_error("the table has no column '" + std::string(name) + "'", {}, "its columns are: " + known);
}

std::vector<double> Table::numbers(std::string_view name) const {
  const Column& c = column(name);
  if (const auto* d = std::get_if<std::vector<double>>(&c.values)) return *d;
  if (const auto* n = std::get_if<std::vector<std::int64_t>>(&c.values)) return {n->begin(), n->end()};
  throw data_error("column '" + c.name + "' holds text, not numbers");
}

}  // namespace jam
