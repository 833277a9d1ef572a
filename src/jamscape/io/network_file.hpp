// Force networks without positions, made by anyone: CSV with the columns i, j, force, and the plain interaction network
// (first line the number of vertices N, every other line `i j value`, i and j from 0 to N - 1).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "jamscape/io/csv.hpp"
#include "jamscape/network/graph.hpp"

namespace jam {

struct NamedGraph {
  WeightedGraph graph;
  std::vector<std::int64_t> ids;        ///< one per vertex, rising: the number it has in the file
  std::vector<std::string> notes = {};  ///< what was left out or assumed, one sentence each, for the person who asked
};

/// Rows with a negative vertex are contacts with walls: wall w is -1 - w.
enum class WallRows { leave_out, keep };

struct NetworkReading {
  WallRows walls = WallRows::leave_out;
  std::optional<double> frame = {};  ///< of a table with several
};

/// Either kind, known by its first line; plain, gzip or zstd.
///
/// CSV: integers from 0 on name the vertices, negative ones walls, which are left out or become vertices of their own;
/// a leading line `# vertices: N` says that there are N, numbered from 0 or from 1, so that those without an edge count
/// too. Names of the columns: i (id1, from, source), j (id2, to, target), force (fn, weight, value). In a table of
/// contacts, rows with an overlap below 0 are left out, and the rows of a grain with one wall (its beads) become one
/// edge, the vector sum of their forces, for which they need normals. Throws a data error with the line for a pair
/// given twice (in either order), a loop, a force that is negative or no number, a vertex out of range, several frames
/// in one table, and a count beyond what any memory holds.
NamedGraph read_network(const std::filesystem::path& path, const NetworkReading& how = {});
NamedGraph read_network(const CsvFile& csv, const NetworkReading& how = {});

/// Whether a text begins as an interaction network does: with a line that is one integer.
bool is_interaction_network(const std::string& text);

/// CSV with `# vertices: N` where the vertices are numbered without gaps from 0 or 1.
void write_network_csv(const std::filesystem::path& path, const NamedGraph& network);

/// The plain interaction network; vertices go by their index.
void write_interaction_network(const std::filesystem::path& path, const WeightedGraph& graph);

}  // namespace jam
