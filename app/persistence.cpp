#include "jamscape/topology/persistence.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/io/network_file.hpp"
#include "normalise.hpp"

namespace jam::app {
namespace {

struct PersistenceArguments {
  std::string file, out, triangles = "fill";
  int max_dimension = 1;
  bool normalise = false, zero_length = false;
  double clamp = 0;
};

/// Columns i, j: the vertices of the contact that makes the point what it is: in dimension 0 the one that joins the
/// component to an older one (an essential component: its first vertex, and -1), in dimension 1 the one that closes the
/// loop; -1 in higher dimensions, where birth_cell counts the cliques.
Table diagram_table(const NamedGraph& network, const Diagram& diagram) {
  std::vector<std::int64_t> dimension, essential, birth_cell, death_cell, i, j;
  std::vector<double> birth, death;
  const WeightedGraph& g = network.graph;
  for (const PersistencePair& p : diagram.pairs) {
    dimension.push_back(p.dimension);
    birth.push_back(p.birth);
    death.push_back(p.death);
    essential.push_back(p.essential ? 1 : 0);
    birth_cell.push_back(p.birth_cell);
    death_cell.push_back(p.death_cell);
    const CellId edge = p.dimension == 0 ? p.death_cell : p.dimension == 1 ? p.birth_cell : -1;
    const auto e = static_cast<std::size_t>(edge);
    const bool vertex = p.dimension == 0 && edge < 0;
    i.push_back(edge >= 0 ? network.ids[g.from[e]] : vertex ? network.ids[static_cast<std::size_t>(p.birth_cell)] : -1);
    j.push_back(edge >= 0 ? network.ids[g.to[e]] : -1);
  }
  Table table;
  table.add("dimension", std::move(dimension));
  table.add("birth", std::move(birth));
  table.add("death", std::move(death));
  table.add("essential", std::move(essential));
  table.add("birth_cell", std::move(birth_cell));
  table.add("death_cell", std::move(death_cell));
  table.add("i", std::move(i));
  table.add("j", std::move(j));
  return table;
}

ExitCode persistence_of_file(const PersistenceArguments& a) {
  NamedGraph network = read_network(a.file);
  if (a.normalise) normalise(network.graph);
  if (a.clamp > 0) clamp(network.graph, a.clamp);
  PersistenceOptions options;
  options.max_dimension = a.max_dimension;
  options.triangles = a.triangles == "keep" ? Triangles::keep : Triangles::fill;
  options.keep_zero_length = a.zero_length;
  const Table table = diagram_table(network, persistence(network.graph, options));
  const CsvMetadata metadata = {{"filtration", "superlevel; a vertex enters at its largest force"},
                                {"triangles", a.triangles},
                                {"forces", a.normalise ? "in mean forces" : "as given"},
                                {"clamp", a.clamp > 0 ? fmt::format("{}", a.clamp) : "none"}};
  if (a.out.empty())
    fmt::print("{}", to_csv(table, metadata));
  else
    write_csv(a.out, table, metadata);
  return ExitCode::done;
}

}  // namespace

void add_persistence(CLI::App& program, Action& action) {
  CLI::App* sub = program.add_subcommand("persistence", "Persistence diagrams of a weighted graph");
  auto a = std::make_shared<PersistenceArguments>();
  sub->add_option("file", a->file, "CSV with the columns i, j, force (plain, .gz or .zst), or an interaction network")
      ->required();
  sub->add_option("--out,-o", a->out, "CSV to write (default: standard output)");
  sub->add_option("--max-dimension", a->max_dimension, "highest dimension of the diagrams")->check(CLI::Range(0, 8));
  sub->add_option("--triangles", a->triangles, "what becomes of three mutual contacts: fill or keep")
      ->check(CLI::IsMember({"fill", "keep"}));
  sub->add_flag("--normalise", a->normalise, "divide the forces by their mean first");
  sub->add_option("--clamp", a->clamp, "largest force kept (0: all)")->check(CLI::NonNegativeNumber);
  sub->add_flag("--zero-length", a->zero_length, "keep points with birth = death");
  sub->callback([a, &action] { action = [a] { return persistence_of_file(*a); }; });
}

}  // namespace jam::app
