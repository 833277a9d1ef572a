#include "jamscape/io/network_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "jamscape/base/error.hpp"
#include "jamscape/base/table.hpp"
#include "jamscape/io/column_names.hpp"
#include "jamscape/io/compressed.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/io/frame_column.hpp"
#include "jamscape/io/leading_lines.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/plain_text.hpp"
#include "jamscape/io/vector_columns.hpp"

namespace jam {
namespace {

constexpr std::int64_t most_vertices = 100'000'000;

/// Edges as they stand in a file, with a way to say where.
struct Edges {
  std::vector<std::int64_t> i, j;
  std::vector<double> force;
  std::vector<std::size_t> row = {};  ///< where an edge stands, if rows were left out
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
  const auto walls = std::lower_bound(ids.begin(), ids.end(), std::int64_t{0});
  const std::int64_t base = walls != ids.end() && *walls >= 1 && ids.back() == *count ? 1 : 0;
  for (std::size_t row = 0; row < edges.i.size(); ++row)
    for (std::int64_t id : {edges.i[row], edges.j[row]})
      if (id >= 0 && (id < base || id >= base + *count))
        throw data_error(fmt::format("vertex {} is out of range: there are {} vertices", id, *count), place(row),
                         fmt::format("number them from 0 to {}", *count - 1));
  const auto first = walls - ids.begin();
  ids.resize(static_cast<std::size_t>(first + *count));
  std::iota(ids.begin() + first, ids.end(), base);
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

const KnownKeys network_keys{.here = {"vertices", "wall"},
                             .once = {"vertices"},
                             .consequential = {"vertices"},
                             .elsewhere = {},
                             .other_table = {}};

/// Force vectors on the grain of every row, for the rows of one grain and one wall.
std::optional<std::vector<Vec3>> normals(const CsvFile& csv) {
  const VectorNames names{{{"nx", "n_x", "normal_x"}, {"ny", "n_y", "normal_y"}, {"nz", "n_z", "normal_z"}}};
  return read_vectors(csv, names, find_column(csv, names[2]) ? 3 : 2);
}

/// The rows of a grain with one wall become one edge in the place of the first: |sum F n|.
void join_wall_rows(const CsvFile& csv, Edges& edges, std::vector<std::string>& notes) {
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> touching;
  for (std::size_t e = 0; e < edges.i.size(); ++e) {
    const auto [wall, grain] = std::minmax(edges.i[e], edges.j[e]);
    if (wall < 0 && std::isfinite(edges.force[e])) touching[{wall, grain}].push_back(e);
  }
  std::vector<char> joined(edges.i.size(), 0);
  std::optional<std::vector<Vec3>> normal;
  std::size_t pairs = 0;
  for (const auto& [pair, rows] : touching) {
    if (rows.size() < 2) continue;
    if (!normal && !(normal = normals(csv))) return;  // then they are a pair given twice
    ++pairs;
    Vec3 sum{};
    for (const std::size_t e : rows) {
      sum += edges.force[e] * (*normal)[edges.row[e]];
      joined[e] = e != rows.front();
    }
    edges.force[rows.front()] = norm(sum);
  }
  if (pairs == 0) return;
  Edges kept;
  for (std::size_t e = 0; e < edges.i.size(); ++e) {
    if (joined[e] != 0) continue;
    kept.i.push_back(edges.i[e]);
    kept.j.push_back(edges.j[e]);
    kept.force.push_back(edges.force[e]);
    kept.row.push_back(edges.row[e]);
  }
  edges = std::move(kept);
  notes.push_back(fmt::format("{} grains touch a wall in several places: one edge each, the sum of the forces", pairs));
}

/// Without the rows of walls, unless they are kept, and without those that say that nothing touches.
Edges chosen_edges(const CsvFile& csv, Edges all, WallRows walls, std::vector<std::string>& notes) {
  const auto overlap = find_column(csv, {"overlap", "delta", "penetration"});
  const std::vector<double> depth = overlap ? csv.numbers(*overlap) : std::vector<double>{};
  std::size_t of_walls = 0, apart = 0;
  bool all_below = overlap && !all.i.empty();
  Edges edges;
  for (std::size_t row = 0; row < all.i.size(); ++row) {
    const bool wall = all.i[row] < 0 || all.j[row] < 0;
    const bool below = overlap && depth[row] < 0, open = below && all.force[row] == 0;  // as find_bonds() has it
    of_walls += wall;
    apart += open;
    all_below = all_below && below;
    if (open || (wall && walls == WallRows::leave_out)) continue;
    edges.i.push_back(all.i[row]);
    edges.j.push_back(all.j[row]);
    edges.force.push_back(all.force[row]);
    edges.row.push_back(row);
  }
  if (of_walls > 0 && walls == WallRows::leave_out)
    notes.push_back(
        fmt::format("{} of {} rows are contacts with walls (negative numbers) and are left out; --walls keeps them, "
                    "each wall a vertex",
                    of_walls, all.i.size()));
  if (apart > 0)
    notes.push_back(fmt::format("{} of {} rows have an overlap below 0 and no force: left out, nothing touches there",
                                apart, all.i.size()));
  if (all_below)
    throw data_error("all overlaps are below 0, so nothing touches", csv.place(0, *overlap),
                     "overlaps are positive where grains touch: turn their sign");
  if (walls == WallRows::keep) join_wall_rows(csv, edges, notes);
  return edges;
}

NamedGraph from_csv(const CsvFile& csv, WallRows walls) {
  const std::size_t i = need_column(csv, {"i", "id1", "from", "source", "particle1", "node1"}, "the first vertex");
  const std::size_t j = need_column(csv, {"j", "id2", "to", "target", "particle2", "node2"}, "the second vertex");
  const std::size_t f =
      need_column(csv, {"force", "fn", "weight", "value", "normal_force", "f"}, "the weight of the edge");
  std::vector<std::string> notes;
  const LeadingLines lines(csv, network_keys, notes);
  const Edges edges = chosen_edges(csv, {csv.integers(i), csv.integers(j), csv.numbers(f)}, walls, notes);
  std::optional<std::int64_t> count;
  if (const CsvRemark* line = lines.find("vertices")) {
    count = parse_integer(line->value);
    if (!count) throw data_error(fmt::format("'{}' is no number of vertices", line->value), line->place);
    check_vertex_count(*count, line->place);
  }
  NamedGraph network = make_graph(edges, count, [&](std::size_t edge) { return csv.place(edges.row[edge], f); });
  network.notes = std::move(notes);
  return network;
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
        throw data_error(
            fmt::format("'{}' is no {}", fields[k].substr(0, 40), k < 2 ? "index of a vertex" : "number"), place(k),
            has_decimal_comma(fields[k]) ? "write a decimal point" : "every line but the first reads: i j value");
    for (std::int64_t id : {*i, *j})
      if (id < 0 || id >= *count)
        throw data_error(fmt::format("vertex {} is out of range: the first line says {} vertices", id, *count),
                         place(0), fmt::format("number them from 0 to {}", *count - 1));
    edges.i.push_back(*i);
    edges.j.push_back(*j);
    edges.force.push_back(*force);
    lines.push_back(number);
  }
  return make_graph(edges, count, [&](std::size_t row) { return fmt::format("{}:{}:1", file, lines[row]); });
}

}  // namespace

/// No header of a CSV table is one integer.
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

NamedGraph read_network(const std::filesystem::path& path, const NetworkReading& how) {
  std::string text = read_plain_text(path);
  if (!is_interaction_network(text)) return read_network(CsvFile::parse(std::move(text), path.string()), how);
  if (how.frame) throw data_error("an interaction network has no frames", path.string(), "leave out --frame");
  return from_interaction_network(text, path.string());
}

NamedGraph read_network(const CsvFile& csv, const NetworkReading& how) {
  return from_csv(one_frame(csv, how.frame).table, how.walls);
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
