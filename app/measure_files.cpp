#include "measure_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>

#include "jamscape/base/error.hpp"
#include "jamscape/io/column_names.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/io/network_file.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/packing_csv.hpp"
#include "jamscape/io/particle_table.hpp"
#include "jamscape/io/plain_text.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/observe/measure.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/topology/bins.hpp"
#include "jamscape/topology/total.hpp"
#include "memory_check.hpp"
#include "normalise.hpp"

namespace jam::app {
namespace {

namespace fs = std::filesystem;

/// Adds the rows of `part` below those of `whole`; an empty whole takes the columns of the part.
void append(Table& whole, const Table& part) {
  if (whole.columns.empty()) {
    whole = part;
    return;
  }
  for (std::size_t c = 0; c < part.columns.size(); ++c)
    std::visit(
        [&](auto& values) {
          const auto& more = std::get<std::decay_t<decltype(values)>>(part.columns[c].values);
          values.insert(values.end(), more.begin(), more.end());
        },
        whole.columns[c].values);
}

/// One measure of several rows a frame.
bool rows_alone(const std::vector<std::string>& names) {
  return names.size() == 1 && find_measure(names.front()).rows == Rows::many;
}

/// The measures of one row a frame side by side, or one measure of several rows.
Table measure_packing(const Packing& packing, const MeasureOptions& options, const std::vector<std::string>& names,
                      std::vector<std::string>& notes) {
  const Snapshot snapshot(packing, options);
  if (rows_alone(names)) return find_measure(names.front()).evaluate(snapshot);
  Table row;
  row.add("packing_fraction", std::vector<double>{packing.packing_fraction});
  for (const Measure& m : measures()) {
    const bool wanted = names.empty() || std::find(names.begin(), names.end(), m.name) != names.end();
    if (!wanted) continue;
    if (m.rows == Rows::many) {
      if (names.empty()) continue;
      throw usage_error(fmt::format("'{}' gives a table of its own", m.name), "--measure", "ask for it alone");
    }
    if (const std::string reason = lacking(m.needs, packing); !reason.empty()) {
      const std::string note = fmt::format("the columns of '{}' are empty: {}", m.name, reason);
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    }
    for (Column& c : m.evaluate(snapshot).columns) row.columns.push_back(std::move(c));
  }
  return row;
}

/// Why a table has no rows.
std::string empty_reason(const FileRequest& request, std::size_t contacts) {
  const std::string& name = request.measures.front();
  if (request.options.rows_every > 0)
    return fmt::format(
        "no rows of '{}': no packing fraction is a multiple of measure.rows_every = {}; 0 takes it always", name,
        to_text(request.options.rows_every));
  if (contacts == 0) return fmt::format("no rows of '{}': the packing has no contacts", name);
  return fmt::format("no rows of '{}': nothing here lies in its range (`jamscape explain {}`)", name, name);
}

bool is_run(const std::string& file) { return fs::path(file).extension() == ".h5"; }

/// Of a run: with the gravity that its grains felt, unless another is asked for.
MeasureOptions options_of(const RunFile& run, const std::string& file, const FileRequest& request,
                          std::vector<std::string>& notes) {
  MeasureOptions options = request.options;
  const std::string study = run.provenance().study;
  if (study.empty() || std::find(request.set.begin(), request.set.end(), "measure.gravity") != request.set.end())
    return options;
  try {
    options.gravity = read_study_text(study, "the study of the run").systems.at(0).options.domain.gravity;
  } catch (const std::exception&) {  // made by a program whose studies this one cannot read
    notes.push_back(fmt::format("the study of '{}' cannot be read: its gravity is taken as measure.gravity = {}", file,
                                to_text(options.gravity)));
  }
  return options;
}

/// All frames of a run, or the one asked for; counts what it has seen.
Table measure_run(const std::string& file, const FileRequest& request, std::size_t& frames, std::size_t& contacts,
                  std::vector<std::string>& notes) {
  Table all;
  const RunFile run(file);
  const double last = static_cast<double>(run.frames()) - 1;
  if (request.frame && !(*request.frame >= 0 && *request.frame <= last && std::floor(*request.frame) == *request.frame))
    throw usage_error(fmt::format("there is no frame {} in '{}'", to_text(*request.frame), file), "--frame",
                      fmt::format("frames are counted from 0 to {}", to_text(last)));
  const MeasureOptions options = options_of(run, file, request, notes);
  for (std::size_t f = 0; f < run.frames(); ++f) {
    if (request.frame && static_cast<double>(f) != *request.frame) continue;
    const Packing packing = run.frame(f);
    contacts += packing.contacts.size();
    ++frames;
    Table rows = measure_packing(packing, options, request.measures, notes);
    if (rows_alone(request.measures)) {  // else rows of different frames could not be told apart
      Table named;
      named.add("frame", std::vector<std::int64_t>(rows.rows(), static_cast<std::int64_t>(f)));
      for (Column& c : rows.columns) named.columns.push_back(std::move(c));
      rows = std::move(named);
    }
    append(all, rows);
  }
  return all;
}

FileResult measure_runs(const FileRequest& request) {
  FileResult result;
  std::size_t contacts = 0, frames = 0;
  for (const std::string& file : request.files) {
    if (!is_run(file))
      throw usage_error(fmt::format("'{}' is no run.h5 file, others are", file), "measure", "give files of one kind");
    try {
      append(result.table, measure_run(file, request, frames, contacts, result.notes));
    } catch (const Error& error) {  // the others go on, unless there are none
      if (error.code() != ExitCode::data || request.files.size() == 1) throw;
      result.notes.push_back(fmt::format("left out: {}", error.what()));
      result.damaged = true;
    }
  }
  if (frames == 0)
    result.notes.push_back("no rows: there are no frames");
  else if (result.table.rows() == 0)
    result.notes.push_back(empty_reason(request, contacts));
  return result;
}

FileResult measure_tables(const FileRequest& request) {
  CsvFile a = CsvFile::read(request.files[0]), b = CsvFile::read(request.files[1]);
  const bool first = holds_particles(a);
  if (first == holds_particles(b))
    throw usage_error(fmt::format("{} of '{}' and '{}' is a table of particles (id, x, y, radius)",
                                  first ? "each" : "neither", request.files[0], request.files[1]),
                      "measure", "a packing is one table of particles and one of contacts (id1, id2, fn)");
  ImportedPacking imported = first ? read_packing(std::move(a), std::move(b), request.frame)
                                   : read_packing(std::move(b), std::move(a), request.frame);
  FileResult result{{}, std::move(imported.notes)};
  result.table = measure_packing(imported.packing, request.options, request.measures, result.notes);
  if (result.table.rows() == 0) result.notes.push_back(empty_reason(request, imported.packing.contacts.size()));
  return result;
}

Table measure_network(NamedGraph network, const FileRequest& request) {
  const MeasureOptions& options = request.options;
  const double mean = normalise(network.graph);
  if (options.clamp > 0) clamp(network.graph, options.clamp);
  if (!request.anyway) refuse_large(network.graph, {}, request.files.front());
  const Diagram diagram = persistence(network.graph);
  BinOptions bins;
  bins.edge = options.rough_includes_edge ? RoughEdge::closed : RoughEdge::open;
  Table row;
  const auto count = [&](const char* name, std::size_t n) {
    row.add(name, std::vector<std::int64_t>{static_cast<std::int64_t>(n)});
  };
  count("vertices", network.graph.vertices);
  count("edges", network.graph.edges());
  row.add("mean_force", std::vector<double>{mean});
  const double vertices = network.graph.vertices;
  row.add("z", std::vector<double>{vertices > 0 ? 2 * static_cast<double>(network.graph.edges()) / vertices
                                                : std::numeric_limits<double>::quiet_NaN()});
  for (const int k : {0, 1}) {
    const BinCounts b = persistence_bins(diagram, k, bins);
    count(k == 0 ? "b0_rough" : "b1_rough", b.rough);
    count(k == 0 ? "b0_strong" : "b1_strong", b.strong);
    count(k == 0 ? "b0_medium" : "b1_medium", b.medium);
    count(k == 0 ? "b0_weak" : "b1_weak", b.weak);
  }
  for (const int k : {0, 1}) row.add(k == 0 ? "tp0" : "tp1", std::vector<double>{total_persistence(diagram, k)});
  return row;
}

NamedGraph read_one_network(const FileRequest& request) {
  const std::string& file = request.files.front();
  const NetworkReading how{request.walls ? WallRows::keep : WallRows::leave_out, request.frame};
  std::string text = read_plain_text(file);
  if (is_interaction_network(text)) return read_network(fs::path(file), how);
  const CsvFile csv = CsvFile::parse(std::move(text), file);
  if (holds_particles(csv) && !find_column(csv, {"id1", "i", "from", "particle1"}))
    throw usage_error(fmt::format("'{}' holds particles, but no contacts", file), "measure",
                      "give the table of their contacts (id1, id2, fn) as well");
  return read_network(csv, how);
}

FileResult measure_one_network(const FileRequest& request) {
  if (!request.measures.empty())
    throw usage_error("a network without grains has no measures of a packing to choose from", "--measure",
                      "give its particles too, or use `jamscape persistence`");
  NamedGraph network = read_one_network(request);
  FileResult result;
  result.notes = network.notes;
  if (network.graph.edges() == 0) result.notes.push_back("the network has no edges");
  for (const std::string& key : request.set)
    if (key != "measure.clamp" && key != "measure.rough_includes_edge")
      result.notes.push_back(fmt::format("{} changes nothing for a network without grains", key));
  result.table = measure_network(std::move(network), request);
  return result;
}

}  // namespace

FileResult measure_files(const FileRequest& request) {
  const bool runs = is_run(request.files.front());
  if (!runs && request.files.size() > 2)
    throw usage_error("give a folder of results, run.h5 files, a network, or particles and contacts", "measure");
  const bool network = !runs && request.files.size() == 1;
  if (!network && (request.walls || request.anyway))
    throw usage_error(fmt::format("{} is for networks without grains", request.walls ? "--walls" : "--anyway"),
                      "measure", "leave it out");
  return runs ? measure_runs(request) : network ? measure_one_network(request) : measure_tables(request);
}

}  // namespace jam::app
