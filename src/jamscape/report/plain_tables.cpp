#include "jamscape/report/plain_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace jam {
namespace {

constexpr std::array<std::string_view, 6> shown = {"z",        "rattlers",          "psi6",
                                                   "pressure", "mean_normal_force", "percolates"};

std::string with_error(double value, double error) {
  if (!std::isfinite(value)) return "&ndash;";
  return std::isfinite(error) ? fmt::format("{:.5g} &plusmn; {:.2g}", value, error) : fmt::format("{:.5g}", value);
}

std::string row(const char* cell, const std::vector<std::string>& fields) {
  std::string text = "<tr>";
  for (const std::string& field : fields) text += fmt::format("<{0}>{1}</{0}>", cell, field);
  return text + "</tr>\n";
}

std::string table(const std::string& title, const std::vector<std::string>& header, const std::string& rows) {
  return rows.empty() ? "" : "<h2>" + title + "</h2>\n<table>\n" + row("th", header) + rows + "</table>\n";
}

std::string transitions(const Results& results) {
  const auto found = results.table("ensemble/transitions.csv");
  if (!found) return {};
  const std::vector<std::string> system = text_column(*found, "system"), quantity = text_column(*found, "quantity");
  const std::vector<double> n = found->numbers("n"), value = found->numbers("value"), error = found->numbers("se");
  std::string rows;
  for (std::size_t k = 0; k < found->rows(); ++k)
    rows +=
        row("td", {escaped(system[k]), escaped(quantity[k]), fmt::format("{}", n[k]), with_error(value[k], error[k])});
  return table("Of all realisations", {"system", "quantity", "runs", "value"}, rows);
}

std::string means(const Results& results) {
  const auto found = results.table("ensemble/frames.csv");
  if (!found) return {};
  const std::vector<std::string> system = text_column(*found, "system"), quantity = text_column(*found, "quantity");
  const std::vector<double> frame = found->numbers("frame"), target = found->numbers("packing_fraction_target"),
                            mean = found->numbers("mean"), error = found->numbers("se");
  struct State {
    double packing_fraction = 0;
    std::map<std::string_view, std::string> values;
  };
  std::map<std::pair<std::string, double>, State> states;
  for (std::size_t k = 0; k < found->rows(); ++k) {
    const auto at = std::find(shown.begin(), shown.end(), quantity[k]);
    if (at == shown.end()) continue;
    State& state = states[{system[k], frame[k]}];
    state.packing_fraction = target[k];
    state.values[*at] = with_error(mean[k], error[k]);
  }
  std::vector<std::string_view> columns;
  for (const std::string_view name : shown)
    if (std::any_of(states.begin(), states.end(), [&](const auto& s) { return s.second.values.contains(name); }))
      columns.push_back(name);
  std::vector<std::string> header = {"system", "frame", "packing fraction"};
  header.insert(header.end(), columns.begin(), columns.end());
  std::string rows;
  for (const auto& [place, state] : states) {
    std::vector<std::string> fields = {escaped(place.first), fmt::format("{}", place.second),
                                       fmt::format("{:.5g}", state.packing_fraction)};
    for (const std::string_view name : columns) {
      const auto at = state.values.find(name);
      fields.push_back(at == state.values.end() ? "" : at->second);
    }
    rows += row("td", fields);
  }
  return table("Means over realisations, frame by frame", header, rows);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string plain_tables(const Results& results) { return transitions(results) + means(results); }

}  // namespace jam
