#include "jamscape/observe/entry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "jamscape/packing/cell.hpp"
#include "jamscape/packing/fields.hpp"

namespace jam {
namespace {

void require_columns(const std::string& measure, std::size_t given, std::size_t declared) {
  if (given != declared)
    throw std::logic_error("measure " + measure + " gave another number of columns than it declares");
}

std::string printed(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

bool takes_rows(const Snapshot& s) {
  return !s.packing().shapes.empty() || is_multiple(s.packing().packing_fraction, s.options().rows_every);
}

}  // namespace

bool is_multiple(double packing_fraction, double every) {
  if (every <= 0) return true;
  return std::abs(std::remainder(packing_fraction, every)) <= 0.01 * every;
}

std::string lacking(const Needs& needs, const Packing& packing) {
  std::string names;
  for_each_field(knowledge_fields, [&](const auto& f) {
    for (bool Knowledge::*const need : needs.known)
      if (need == f.member && !(packing.knows.*need)) names += (names.empty() ? "" : ", ") + printed(f.name);
  });
  if (!names.empty()) return names + " are not given";
  if (needs.upright_walls && !packing.walls.empty() && !reduced(packing.domain, packing.dimension).upright())
    return "the cell between the walls is tilted";
  return {};
}

Measure frame_measure(MeasureText text, std::vector<ColumnInfo> columns,
                      std::function<std::vector<double>(const Snapshot&)> values, Needs needs) {
  Measure m{text.name, text.title, text.formula, text.source, Rows::frame, columns, 0, true, {}, {}, needs};
  m.evaluate = [name = text.name, columns = std::move(columns), values = std::move(values),
                needs = std::move(needs)](const Snapshot& s) {
    const std::vector<double> row = lacking(needs, s.packing()).empty()
                                        ? values(s)
                                        : std::vector<double>(columns.size(), std::numeric_limits<double>::quiet_NaN());
    require_columns(name, row.size(), columns.size());
    Table table;
    table.columns.reserve(row.size());
    for (std::size_t k = 0; k < row.size(); ++k) table.add(columns[k].name, std::vector<double>{row[k]});
    return table;
  };
  return m;
}

Measure seldom_measure(MeasureText text, std::vector<ColumnInfo> columns,
                       std::function<std::vector<double>(const Snapshot&)> values) {
  text.formula += " Missing at packing fractions that are no multiples of rows_every (discs and spheres).";
  const std::size_t count = columns.size();
  return frame_measure(std::move(text), std::move(columns), [count, values = std::move(values)](const Snapshot& s) {
    return takes_rows(s) ? values(s) : std::vector<double>(count, std::numeric_limits<double>::quiet_NaN());
  });
}

Measure rows_measure(MeasureText text, std::vector<ColumnInfo> columns, int abscissae, bool averaged,
                     std::function<std::vector<std::vector<double>>(const Snapshot&)> values) {
  Measure m{text.name, text.title, text.formula, text.source, Rows::many, columns, abscissae, averaged, {}};
  m.evaluate = [name = text.name, columns = std::move(columns), values = std::move(values)](const Snapshot& s) {
    Table table;
    if (!takes_rows(s)) {
      for (const ColumnInfo& c : columns) table.add(c.name, std::vector<double>{});
      return table;
    }
    std::vector<std::vector<double>> rows = values(s);
    require_columns(name, rows.size(), columns.size());
    for (std::size_t k = 0; k < rows.size(); ++k) table.add(columns[k].name, std::move(rows[k]));
    return table;
  };
  return m;
}

}  // namespace jam
