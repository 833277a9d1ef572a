// Force networks without positions, made by anyone: CSV with the columns i, j, force, and the plain interaction network
// (first line the number of vertices N, every other line `i j value`, i and j from 0 to N - 1).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "jamscape/network/graph.hpp"

namespace jam {

struct NamedGraph {
  WeightedGraph graph;
  std::vector<std::int64_t> ids;  ///< one per vertex, rising: the number it has in the file
};

/// Either kind, known by its first line; plain, gzip or zstd.
///
/// CSV: any integers name the vertices; a leading line `# vertices: N` says that there are N, numbered from 0 or from
/// 1, so that those without an edge count too. Names of the columns: i (id1, from, source), j (id2, to, target), force
/// (fn, weight, value); other columns are left alone. Throws a data error with the line for a pair given twice (in
/// either order), a loop, a force that is negative or no number, a vertex out of range, and a count beyond what any
/// memory holds.
NamedGraph read_network(const std::filesystem::path& path);

/// CSV with `# vertices: N` where the vertices are numbered without gaps from 0 or 1.
void write_network_csv(const std::filesystem::path& path, const NamedGraph& network);

/// The plain interaction network; vertices go by their index.
void write_interaction_network(const std::filesystem::path& path, const WeightedGraph& graph);

}  // namespace jam
