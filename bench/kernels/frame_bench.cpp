// What measuring one frame costs: all scalar and topological measures of a packing as in S1 (2025 frictional discs
// between bead walls, jammed), on one core.
//
//   frame_bench [RUN.h5] [options of Google Benchmark]     frames of a run, or else of a fast compression made here
//
// Printed: the first frame that the process measures (its memory is new, so every page of it faults once); then the
// share of each measure, median over many rounds through all frames; frames follow each other, as in a study, because
// the same frame again and again is faster by a quarter: the processor learns its branches by heart. What several
// measures use (bonds, force network, components, persistence, clusters at all thresholds) stands on lines of its own.
// Google Benchmark has the sum again, as one number. Left out are distributions, fits and resampling, which a study
// takes at few frames (option rows_every).
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/observe/measure.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace {

using namespace jam;

constexpr double lowest = 0.84, highest = 0.9;  // packing fractions; jamming is near .79

const std::vector<std::string> measured = {
    "contacts",    "coordination", "backbone", "bond_order", "persistence_bins", "total_persistence",
    "percolation", "stress",       "walls",    "balance",    "energy",           "box",
    "betti",       "level_sets",   "diagram"};

/// S1's densest system, friction .5 and size spread .4, at eighty times its wall speed.
std::vector<Packing> compressed() {
  SystemOptions system;
  system.contact.friction = 0.5;
  system.grains.width = 0.4;
  system.integrator.scheme = Scheme::gear5;
  StageOptions stage;
  stage.to = highest;
  stage.speed = 2e-3;
  for (int k = 0; k < 8; ++k) stage.frames_at.push_back(lowest + (highest - lowest) * k / 7);
  system.stages = {stage};
  std::vector<Packing> frames;
  Hooks hooks;
  hooks.frame = [&](std::size_t, const Packing& p) { frames.push_back(p); };
  simulate(system, {2013, "frame_bench", 0}, hooks);
  return frames;
}

std::vector<Packing> read(const std::string& file) {
  const RunFile run(file);
  std::vector<Packing> frames;
  for (std::size_t k = 0; k < run.frames(); ++k)
    if (run.packing_fractions()[k] > lowest - 1e-6) frames.push_back(run.frame(k));
  if (frames.empty()) throw data_error(fmt::format("{} has no frame above {}", file, lowest));
  return frames;
}

MeasureOptions every_frame() {
  MeasureOptions options;
  options.rows_every = 0;
  return options;
}

using Clock = std::chrono::steady_clock;

double microseconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::micro>(to - from).count();
}

/// A measure, or what several measures use.
struct Part {
  std::string name;
  std::function<void(const Snapshot&)> evaluate;
};

std::vector<Part> list_parts() {
  std::vector<Part> parts = {{"(bonds)", [](const Snapshot& s) { s.bonds(); }},
                             {"(force network)", [](const Snapshot& s) { s.network(); }},
                             {"(components)", [](const Snapshot& s) { s.history(); }},
                             {"(persistence)", [](const Snapshot& s) { s.diagram(); }},
                             {"(clusters at all thresholds)", [](const Snapshot& s) { s.levels(); }}};
  for (const std::string& name : measured)
    parts.push_back({name, [&m = find_measure(name)](const Snapshot& s) { benchmark::DoNotOptimize(m.evaluate(s)); }});
  return parts;
}

/// Microseconds of each part and of the whole frame.
std::vector<double> measure(const Packing& packing, const std::vector<Part>& parts, SnapshotMemory& memory) {
  std::vector<double> spent;
  spent.reserve(parts.size() + 1);
  const auto start = Clock::now();
  {
    const Snapshot snapshot(packing, every_frame(), &memory);
    auto last = start;
    for (const Part& part : parts) {
      part.evaluate(snapshot);
      const auto now = Clock::now();
      spent.push_back(microseconds(last, now));
      last = now;
    }
  }
  spent.push_back(microseconds(start, Clock::now()));
  return spent;
}

void print_shares(const std::vector<Packing>& frames, const std::vector<Part>& parts, SnapshotMemory& memory) {
  std::vector<std::vector<double>> times(parts.size() + 1);
  for (int round = 0; round < 200; ++round)
    for (const Packing& frame : frames) {
      const auto spent = measure(frame, parts, memory);
      for (std::size_t k = 0; k < spent.size(); ++k) times[k].push_back(spent[k]);
    }
  const auto middle = [](std::vector<double>& t) {
    std::nth_element(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(t.size() / 2), t.end());
    return t[t.size() / 2];
  };
  const double whole = middle(times.back());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double part = middle(times[k]);
    fmt::print("{:<30}{:>9.1f} us{:>7.1f} %\n", parts[k].name, part, 100 * part / whole);
  }
  fmt::print("{:<30}{:>9.1f} us\n", "a frame", whole);
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const auto frames = argc > 1 ? read(argv[1]) : compressed();
  const auto parts = list_parts();
  std::size_t contacts = 0;
  for (const Packing& p : frames) contacts += p.contacts.size();
  fmt::print("{} frames, {} grains, {} contacts on average\n", frames.size(), frames[0].grains.size(),
             contacts / frames.size());
  SnapshotMemory memory;  // shared by all frames, as a study's are
  fmt::print("{:<30}{:>9.1f} us\n", "the first frame", measure(frames[0], parts, memory).back());
  fmt::print("{:<30}{:>9.1f} us\n", "the second frame", measure(frames[1 % frames.size()], parts, memory).back());
  print_shares(frames, parts, memory);

  std::size_t next = 0;
  benchmark::RegisterBenchmark("all measures of a frame, frames in turn", [&](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(measure(frames[next++ % frames.size()], parts, memory));
  })->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("all measures, the same frame again and again", [&](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(measure(frames[0], parts, memory));
  })->Unit(benchmark::kMicrosecond);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace

int main(int argc, char** argv) try { return run(argc, argv); } catch (const std::exception& error) {
  fmt::print(stderr, "frame_bench: {}\n", error.what());
  return 1;
}
