#include "jamscape/topology/persistence.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "cell_list.hpp"
#include "commands.hpp"
#include "complain.hpp"
#include "jamscape/base/printable.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/io/network_file.hpp"
#include "memory_check.hpp"
#include "normalise.hpp"

namespace jam::app {
namespace {

struct PersistenceArguments {
  std::string file, out, cells, triangles = "fill";
  int max_dimension = 1;
  bool normalise = false, zero_length = false;
  double clamp = 0;
  std::optional<double> frame;
  bool walls = false, anyway = false;
};

ExitCode persistence_of_file(const PersistenceArguments& a) {
  NamedGraph network = read_network(a.file, {a.walls ? WallRows::keep : WallRows::leave_out, a.frame});
  for (const std::string& note : network.notes) complain("note: {}\n", printable(note));
  if (a.normalise) normalise(network.graph);
  if (a.clamp > 0) clamp(network.graph, a.clamp);
  PersistenceOptions options;
  options.max_dimension = a.max_dimension;
  options.triangles = a.triangles == "keep" ? Triangles::keep : Triangles::fill;
  options.keep_zero_length = a.zero_length;
  if (!a.anyway) refuse_large(network.graph, options, a.file);
  const Diagram diagram = persistence(network.graph, options);
  const Table table = diagram_table(network, diagram);
  const CsvMetadata metadata = {{"filtration", "superlevel; a vertex enters at its largest force"},
                                {"triangles", a.triangles},
                                {"forces", a.normalise ? "in mean forces" : "as given"},
                                {"cells", "vertices by number, contacts as read, larger cliques as they enter"},
                                {"clamp", a.clamp > 0 ? fmt::format("{}", a.clamp) : "none"}};
  if (a.out.empty())
    fmt::print("{}", to_csv(table, metadata));
  else
    write_csv(a.out, table, metadata);
  if (!a.cells.empty()) write_csv(a.cells, cell_table(network, diagram), metadata);
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
  sub->add_option("--cells", a->cells, "CSV to write: the vertices of the cells that the diagram names");
  sub->add_option("--frame", a->frame, "of a table with several frames: the one to take");
  sub->add_flag("--walls", a->walls, "keep contacts with walls (negative numbers), each wall a vertex");
  sub->add_flag("--anyway", a->anyway, "however much memory it takes");
  sub->add_flag("--zero-length", a->zero_length, "keep points with birth = death");
  sub->callback([a, &action] { action = [a] { return persistence_of_file(*a); }; });
}

}  // namespace jam::app
