#include "jamscape/observe/explain.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace jam {
namespace {

std::string where(const Measure& m) {
  if (m.rows == Rows::frame) return "one row a frame, in the table 'frames'";
  return fmt::format("several rows a frame, in the table '{}'{}", m.name, m.averaged ? "" : "; not averaged");
}

// Keeps Markdown from reading <F> as a tag and |x| as the border of a cell.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '|')
      out += "\\|";
    else if (c == '*' || c == '_')
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

/// What a column of the ensemble holds where it is no plain mean.
std::string averaged(Averaging averaging) {
  if (averaging == Averaging::nonzero_or_missing)
    return "; averaged over realisations with a value other than 0, missing if fewer than half have one";
  if (averaging == Averaging::nonzero_or_zero)
    return "; averaged over realisations with a value other than 0, 0 if at least half are 0";
  return "";
}

std::string pooled(const PooledRatio& r) {
  return fmt::format("{} = sum({})/sum({}) over realisations", r.text, r.over, r.under);
}

const Measure* giving(std::string_view column) {
  for (const Measure& m : measures()) {
    for (const ColumnInfo& c : m.columns)
      if (c.name == column) return &m;
    for (const PooledRatio& r : m.ratios)
      if (r.name == column) return &m;
  }
  return nullptr;
}

}  // namespace

std::string explain(const Measure& m) {
  std::string text = fmt::format("{}: {}\n  {}\n  source: {}\n  {}\n", m.name, m.title, m.formula, m.source, where(m));
  std::size_t widest = 0;
  for (const ColumnInfo& c : m.columns) widest = std::max(widest, c.name.size());
  for (const ColumnInfo& c : m.columns)
    text += fmt::format("    {:<{}}  {}{}{}\n", c.name, widest, c.text, averaged(c.averaging),
                        c.unit.empty() ? "" : " [" + c.unit + "]");
  for (const PooledRatio& r : m.ratios) text += fmt::format("    ensemble: {}  {}\n", r.name, pooled(r));
  return text;
}

std::string explain_measure(std::string_view name_or_column) {
  const auto& all = measures();
  const bool named = std::any_of(all.begin(), all.end(), [&](const Measure& m) { return m.name == name_or_column; });
  const Measure* m = named ? nullptr : giving(name_or_column);
  return explain(m ? *m : find_measure(name_or_column));
}

std::string measures_reference() {
  std::string text = "# Measures\n";
  for (const Measure& m : measures()) {
    text += fmt::format("\n## {}\n\n{}: {}\n\nSource: {}. Gives {}.\n\n| column | unit | meaning |\n|---|---|---|\n",
                        m.name, plain(m.title), plain(m.formula), plain(m.source), plain(where(m)));
    for (const ColumnInfo& c : m.columns)
      text += fmt::format("| `{}` | {} | {} |\n", c.name, plain(c.unit), plain(c.text + averaged(c.averaging)));
    for (const PooledRatio& r : m.ratios)
      text += fmt::format("\nIn the ensemble also `{}`: {}.\n", r.name, plain(pooled(r)));
  }
  return text;
}

}  // namespace jam
