#include "jamscape/study/done_tasks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/relaxation.hpp"
#include "jamscape/stats/moments.hpp"
#include "jamscape/study/ledger.hpp"

namespace jam {
namespace {

std::vector<DoneTask> find_simulated(const std::vector<Task>& tasks, const ResultPlaces& places,
                                     const std::vector<LeftOut>& left_out,
                                     const std::vector<const Measure*>& measures) {
  std::vector<DoneTask> done;
  for (const Task& task : tasks) {
    TaskFolder folder = folder_with_rows(places, task.hash, measures);
    if (is_left_out(left_out, task.hash) || !has_all_frames(folder, task.plan) || !has_rows(folder, measures)) continue;
    std::vector<std::size_t> stored = stored_frames(RunFile(folder.run_file(), Look::structure), task.plan).value();
    done.push_back(
        {.task = &task, .folder = std::move(folder), .frames = task.plan.frames, .stored = std::move(stored)});
  }
  return done;
}

/// From tables that are all there is.
std::vector<DoneTask> find_collected(const Study& study, const std::vector<Task>& tasks,
                                     const std::filesystem::path& results,
                                     const std::vector<const Measure*>& measures) {
  std::vector<std::map<std::uint64_t, CollectedTask>> of_system;
  for (const System& system : study.systems) of_system.push_back(read_collected(results, system.name, measures));
  std::vector<DoneTask> done;
  for (const Task& task : tasks) {
    auto& held = of_system[task.system];
    const auto at = held.find(task.realisation);
    if (at == held.end()) continue;
    std::vector<std::size_t> stored(at->second.frames.size());
    for (std::size_t f = 0; f < stored.size(); ++f) stored[f] = f;
    const auto rows = std::make_shared<CollectedTask>(std::move(at->second));
    done.push_back({.task = &task,
                    .folder = TaskFolder(results, task.hash),
                    .frames = rows->frames,
                    .stored = std::move(stored),
                    .collected = rows});
  }
  return done;
}

/// Where the abscissa is what comes out, frames get its mean over the realisations, so that one state has one.
void set_reached_fractions(const Study& study, std::vector<DoneTask>& done) {
  constexpr std::size_t fraction = 2;  // of instant_measure(): step, time, packing_fraction, ...
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    if (plans_packing_fraction(study.systems[s].options)) continue;
    std::map<std::size_t, std::vector<double>> found;
    for (const DoneTask& d : done) {
      if (d.task->system != s) continue;
      const FrameRows rows = read_frame_rows(d, instant_measure());
      for (std::size_t f = 0; f < rows.size(); ++f) found[f].push_back(rows[f].at(0).at(fraction));
    }
    for (DoneTask& d : done)
      if (d.task->system == s)
        for (std::size_t f = 0; f < d.frames.size(); ++f) d.frames[f].packing_fraction = moments(found[f]).mean;
  }
}

/// Does a frame belong in means beside those of the first realisation?
bool counts(const DoneTask& d, const DoneTask& first, std::size_t f) {
  return !d.left_out[f] && !(std::abs(d.frames[f].packing_fraction - first.frames[f].packing_fraction) > 1e-6);
}

}  // namespace

TaskFolder folder_with_rows(const ResultPlaces& places, const std::string& hash,
                            const std::vector<const Measure*>& measures) {
  TaskFolder elsewhere(places.results, hash, places.rows);
  return has_rows(elsewhere, measures) ? elsewhere : TaskFolder(places.results, hash);
}

std::vector<DoneTask> find_done(const Study& study, const std::vector<Task>& tasks, const ResultPlaces& places,
                                const std::vector<LeftOut>& left_out) {
  const std::vector<const Measure*> chosen = chosen_measures(study);
  std::vector<DoneTask> done = is_collected(places.results) ? find_collected(study, tasks, places.results, chosen)
                                                            : find_simulated(tasks, places, left_out, chosen);
  set_reached_fractions(study, done);
  for (DoneTask& d : done) {
    d.ledger_error = ledger_errors(study, d);
    for (const double error : d.ledger_error) {
      d.marked.push_back(error > study.info.ledger_mark);
      d.left_out.push_back(d.marked.back() && study.info.ledger == LedgerRule::closed);
    }
  }
  return done;
}

std::vector<const Measure*> measured(const Study& study, const std::vector<DoneTask>& done) {
  std::vector<const Measure*> measures = chosen_measures(study);
  std::erase_if(measures, [&](const Measure* m) {
    return std::any_of(done.begin(), done.end(),
                       [&](const DoneTask& d) { return d.collected && !d.collected->rows.contains(m->name); });
  });
  return measures;
}

CachedRows read_rows(const DoneTask& done, const Measure& measure) {
  return done.collected ? done.collected->rows.at(measure.name) : read_cached_rows(done.folder, measure);
}

std::vector<std::string> relaxations(const DoneTask& done) {
  std::vector<std::string> texts(done.stored.size());
  const Measure& measure = relaxation_measure();
  if (done.collected ? !done.collected->rows.contains(measure.name) : !has_rows(done.folder, {&measure})) return texts;
  const CachedRows rows = read_rows(done, measure);
  for (std::size_t f = 0; f < texts.size(); ++f)
    if (done.stored[f] < rows.lines.size() && rows.lines[done.stored[f]].size() == 1)
      texts[f] = rows.lines[done.stored[f]].front();
  return texts;
}

std::size_t frames_not_relaxed(const std::vector<DoneTask>& done) {
  std::size_t n = 0;
  for (const DoneTask& d : done)
    for (const std::string& relaxation : relaxations(d)) n += relaxation == not_relaxed;
  return n;
}

bool relaxes(const Study& study) {
  for (const System& system : study.systems)
    for (const StageOptions& stage : system.options.stages)
      if (stage.traits().relaxes) return true;
  return false;
}

const std::vector<std::vector<double>>* FrameSeries::find(std::string_view name) const {
  const auto at = std::find(quantity.begin(), quantity.end(), name);
  return at == quantity.end() ? nullptr : &value[static_cast<std::size_t>(at - quantity.begin())];
}

FrameSeries read_frame_series(const std::vector<const DoneTask*>& done, const std::vector<const Measure*>& measures) {
  FrameSeries series;
  series.realisations = done.size();
  std::vector<const Measure*> per_frame = {&instant_measure()};
  for (const Measure* m : measures)
    if (m->rows == Rows::frame) per_frame.push_back(m);
  for (const Measure* m : per_frame)
    for (const ColumnInfo& c : m->columns)
      if (c.name != "step" && c.name != "time")
        series.quantity.push_back(c.name), series.averaging.push_back(c.averaging);
  const bool any_relaxed = std::any_of(done.begin(), done.end(), [](const DoneTask* d) {
    return std::any_of(d->frames.begin(), d->frames.end(), [](const PlannedFrame& f) { return f.relaxed; });
  });
  if (any_relaxed) series.quantity.push_back("not_relaxed"), series.averaging.push_back(Averaging::mean);
  series.value.resize(series.quantity.size());
  if (done.empty()) return series;

  std::size_t frames = done.front()->stored.size();
  for (const DoneTask* d : done) frames = std::min(frames, d->stored.size());
  for (std::size_t f = 0; f < frames; ++f) {
    const PlannedFrame& frame = done.front()->frames[f];
    series.target.push_back(frame.packing_fraction);
    series.kinds.push_back({frame.stage, frame.packing_fraction, frame.relaxed});
    const auto out = [f](const DoneTask* d) { return d->left_out[f]; };
    series.marked.push_back(static_cast<std::size_t>(
        std::count_if(done.begin(), done.end(), [f](const DoneTask* d) { return d->marked[f]; })));
    series.left_out.push_back(std::any_of(done.begin(), done.end(), out));
  }
  for (const DoneTask* d : done) {
    std::size_t q = 0;
    for (const Measure* m : per_frame) {
      const FrameRows rows = read_frame_rows(*d, *m);
      for (std::size_t c = 0; c < m->columns.size(); ++c) {
        if (m->columns[c].name == "step" || m->columns[c].name == "time") continue;
        std::vector<double> values;
        for (std::size_t f = 0; f < frames; ++f)
          values.push_back(counts(*d, *done.front(), f) ? rows[f].at(0).at(c) : std::nan(""));
        series.value[q++].push_back(std::move(values));
      }
    }
    if (!any_relaxed) continue;
    std::vector<double> values;
    for (const std::string& relaxation : relaxations(*d)) values.push_back(relaxation == not_relaxed ? 1 : 0);
    values.resize(frames);
    series.value[q].push_back(std::move(values));
  }
  return series;
}

FrameRows read_frame_rows(const DoneTask& done, const Measure& measure) {
  const CachedRows cached = read_rows(done, measure);
  const std::string file = done.folder.tables().string();
  FrameRows rows(done.stored.size());
  for (std::size_t f = 0; f < done.stored.size(); ++f) {
    if (done.stored[f] < cached.lines.size())
      for (const std::string& line : cached.lines[done.stored[f]]) rows[f].push_back(read_numbers(line, file));
    for (const std::vector<double>& row : rows[f])
      if (row.size() != measure.columns.size())
        throw data_error(fmt::format("a row of the measure '{}' has {} columns, not {}", measure.name, row.size(),
                                     measure.columns.size()),
                         file, "jamscape measure DIR --again");
    if (measure.rows == Rows::frame && rows[f].size() != 1)
      throw data_error(fmt::format("frame {} of the measure '{}' is missing", f, measure.name), file,
                       "jamscape measure DIR --again");
  }
  return rows;
}

std::vector<std::vector<const DoneTask*>> by_system(const Study& study, const std::vector<DoneTask>& done) {
  std::vector<std::vector<const DoneTask*>> groups(study.systems.size());
  for (const DoneTask& d : done) groups[d.task->system].push_back(&d);
  return groups;
}

}  // namespace jam
