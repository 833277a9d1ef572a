#include "jamscape/io/network_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "jamscape/base/error.hpp"
#include "jamscape/base/table.hpp"
#include "jamscape/io/column_names.hpp"
#include "jamscape/io/compressed.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/io/number_text.hpp"

namespace jam {
namespace {

constexpr std::int64_t most_vertices = 100'000'000;

/// Edges as they stand in a file, with a way to say where.
struct Edges {
  std::vector<std::int64_t> i, j;
  std::vector<double> force;
};

void check_vertex_count(std::int64_t count, const std::string& place) {
  if (count < 0 || count > most_vertices)
    throw data_error(fmt::format("{} vertices are not a number this program can hold (0 to {})", count, most_vertices),
                     place);
}

/// `place(row)` names the line of a row.
template <class Place>
void check_edges(const Edges& edges, const Place& place) {
  std::vector<std::tuple<std::int64_t, std::int64_t, std::size_t>> pairs;
  pairs.reserve(edges.i.size());
  for (std::size_t row = 0; row < edges.i.size(); ++row) {
    const std::int64_t i = edges.i[row], j = edges.j[row];
    if (i == j) throw data_error(fmt::format("vertex {} is linked to itself", i), place(row), "remove this row");
    if (!std::isfinite(edges.force[row]))
      throw data_error(fmt::format("the force between {} and {} is {}", i, j, to_text(edges.force[row])), place(row),
                       "remove the row, or find out why its force is no number");
    if (edges.force[row] < 0)
      throw data_error(fmt::format("the force between {} and {} is negative: {}", i, j, to_text(edges.force[row])),
                       place(row),
                       "persistence needs forces >= 0; flip the sign if yours counts attraction as positive");
    pairs.emplace_back(std::min(i, j), std::max(i, j), row);
  }
  std::sort(pairs.begin(), pairs.end());
  std::optional<std::pair<std::size_t, std::size_t>> repeated;  // the earliest row that repeats another
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    const auto& [i0, j0, row0] = pairs[k - 1];
    const auto& [i1, j1, row1] = pairs[k];
    if (i0 == i1 && j0 == j1 && (!repeated || row1 < repeated->second)) repeated = {row0, row1};
  }
  if (repeated)
    throw data_error(fmt::format("the pair {}, {} was given before, at {}", edges.i[repeated->second],
                                 edges.j[repeated->second], place(repeated->first)),
                     place(repeated->second),
                     "give each pair once: sum the forces of its contacts, or average mirrored rows");
}

/// The numbers of the vertices, rising.
template <class Place>
std::vector<std::int64_t> vertex_ids(const Edges& edges, std::optional<std::int64_t> count, const Place& place) {
  std::vector<std::int64_t> ids(edges.i);
  ids.insert(ids.end(), edges.j.begin(), edges.j.end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (!count) return ids;
  const std::int64_t base = !ids.empty() && ids.front() >= 1 && ids.back() == *count ? 1 : 0;
  for (std::size_t row = 0; row < edges.i.size(); ++row)
    for (std::int64_t id : {edges.i[row], edges.j[row]})
      if (id < base || id >= base + *count)
        throw data_error(fmt::format("vertex {} is out of range: there are {} vertices", id, *count), place(row),
                         fmt::format("number them from 0 to {}", *count - 1));
  ids.resize(static_cast<std::size_t>(*count));
  std::iota(ids.begin(), ids.end(), base);
  return ids;
}

template <class Place>
NamedGraph make_graph(const Edges& edges, std::optional<std::int64_t> count, const Place& place) {
  check_edges(edges, place);
  NamedGraph network{{}, vertex_ids(edges, count, place)};
  const auto index = [&](std::int64_t id) {
    return static_cast<std::uint32_t>(std::lower_bound(network.ids.begin(), network.ids.end(), id) -
                                      network.ids.begin());
  };
  network.graph.vertices = static_cast<std::uint32_t>(network.ids.size());
  for (std::size_t row = 0; row < edges.i.size(); ++row) {
    network.graph.from.push_back(index(edges.i[row]));
    network.graph.to.push_back(index(edges.j[row]));
  }
  network.graph.weight = edges.force;
  return network;
}

NamedGraph from_csv(const CsvFile& csv) {
  const std::size_t i = need_column(csv, {"i", "id1", "from", "source", "particle1", "node1"}, "the first vertex");
  const std::size_t j = need_column(csv, {"j", "id2", "to", "target", "particle2", "node2"}, "the second vertex");
  const std::size_t f =
      need_column(csv, {"force", "fn", "weight", "value", "normal_force", "f"}, "the weight of the edge");
  const Edges edges{csv.integers(i), csv.integers(j), csv.numbers(f)};
  std::optional<std::int64_t> count;
  for (const auto& [key, value] : csv.metadata()) {
    if (key != "vertices") continue;
    count = parse_integer(value);
    if (!count) throw data_error(fmt::format("'{}' is no number of vertices", value), csv.file());
    check_vertex_count(*count, csv.file());
  }
  return make_graph(edges, count, [&](std::size_t row) { return csv.place(row, f); });
}

/// Splits at blanks.
std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> out;
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t\r", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.size(), line.find_first_of(" \t\r", at));
    out.push_back(line.substr(at, end - at));
    at = end;
  }
  return out;
}

NamedGraph from_interaction_network(const std::string& text, const std::string& file) {
  std::optional<std::int64_t> count;
  Edges edges;
  std::vector<std::size_t> lines;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.size(), text.find('\n', at));
    const std::string_view line(text.data() + at, end - at);
    at = end + 1;
    ++number;
    const auto fields = words(line);
    if (fields.empty() || fields[0][0] == '#') continue;
    const auto place = [&](std::size_t field) {
      const auto column = fields.size() > field ? fields[field].data() - line.data() + 1 : 1;
      return fmt::format("{}:{}:{}", file, number, column);
    };
    if (!count) {
      count = parse_integer(fields[0]);
      check_vertex_count(count.value_or(-1), place(0));
      continue;
    }
    if (fields.size() != 3)
      throw data_error(fmt::format("a row holds {} numbers instead of three: '{}'", fields.size(), line.substr(0, 40)),
                       place(0), "every line but the first reads: i j value");
    const auto i = parse_integer(fields[0]), j = parse_integer(fields[1]);
    const auto force = parse_double(fields[2]);
    for (std::size_t k = 0; k < 3; ++k)
      if (k == 0 ? !i : k == 1 ? !j : !force)
        throw data_error(fmt::format("'{}' is no {}", fields[k].substr(0, 40), k < 2 ? "index of a vertex" : "number"),
                         place(k), "every line but the first reads: i j value");
    for (std::int64_t id : {*i, *j})
      if (id < 0 || id >= *count)
        throw data_error(fmt::format("vertex {} is out of range: the first line says {} vertices", id, *count),
                         place(0), fmt::format("number them from 0 to {}", *count - 1));
    edges.i.push_back(*i);
    edges.j.push_back(*j);
    edges.force.push_back(*force);
    lines.push_back(number);
  }
  return make_graph(edges, count, [&](std::size_t row) { return fmt::format("{}:{}", file, lines[row]); });
}

/// An interaction network begins with a line that is one integer; no header of a CSV table is.
bool is_interaction_network(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.size(), text.find('\n', at));
    const auto fields = words({text.data() + at, end - at});
    at = end + 1;
    if (fields.empty() || fields[0][0] == '#') continue;
    return fields.size() == 1 && parse_integer(fields[0]).has_value();
  }
  return false;
}

}  // namespace

NamedGraph read_network(const std::filesystem::path& path) {
  std::string text = read_any_text(path);
  if (is_interaction_network(text)) return from_interaction_network(text, path.string());
  return from_csv(CsvFile::parse(std::move(text), path.string()));
}

void write_network_csv(const std::filesystem::path& path, const NamedGraph& network) {
  const WeightedGraph& graph = network.graph;
  const auto named = [&](const std::vector<std::uint32_t>& ends) {
    std::vector<std::int64_t> ids;
    for (std::uint32_t v : ends) ids.push_back(network.ids[v]);
    return ids;
  };
  Table table;
  table.add("i", named(graph.from));
  table.add("j", named(graph.to));
  table.add("force", graph.weight);
  CsvMetadata metadata;
  const auto& ids = network.ids;
  if (ids.empty() ||
      ((ids.front() == 0 || ids.front() == 1) && ids.back() - ids.front() + 1 == static_cast<std::int64_t>(ids.size())))
    metadata.emplace_back("vertices", fmt::format("{}", graph.vertices));
  write_csv(path, table, metadata);
}

void write_interaction_network(const std::filesystem::path& path, const WeightedGraph& graph) {
  std::string text = fmt::format("{}\n", graph.vertices);
  for (std::size_t e = 0; e < graph.edges(); ++e)
    text += fmt::format("{} {} {}\n", graph.from[e], graph.to[e], to_text(graph.weight[e]));
  write_any_text(path, text);
}

}  // namespace jam
