#include "jamscape/study/done_tasks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "jamscape/base/error.hpp"

namespace jam {

std::vector<DoneTask> find_done(const std::vector<Task>& tasks, const std::filesystem::path& results,
                                const std::vector<const Measure*>& measures) {
  std::vector<DoneTask> done;
  for (const Task& task : tasks) {
    TaskFolder folder(results, task.hash);
    if (!has_all_frames(folder, task.plan) || !has_rows(folder, measures)) continue;
    std::vector<std::size_t> stored = stored_frames(RunFile(folder.run_file()), task.plan).value();
    done.push_back({&task, std::move(folder), std::move(stored)});
  }
  return done;
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
      if (c.name != "step" && c.name != "time") series.quantity.push_back(c.name);
  series.value.resize(series.quantity.size());
  if (done.empty()) return series;

  std::size_t frames = done.front()->stored.size();
  for (const DoneTask* d : done) frames = std::min(frames, d->stored.size());
  for (std::size_t f = 0; f < frames; ++f) series.target.push_back(done.front()->task->plan.frames[f].packing_fraction);
  for (const DoneTask* d : done) {
    std::size_t q = 0;
    for (const Measure* m : per_frame) {
      const FrameRows rows = read_frame_rows(*d, *m);
      for (std::size_t c = 0; c < m->columns.size(); ++c) {
        if (m->columns[c].name == "step" || m->columns[c].name == "time") continue;
        std::vector<double> values;
        for (std::size_t f = 0; f < frames; ++f) values.push_back(rows[f].at(0).at(c));
        series.value[q++].push_back(std::move(values));
      }
    }
  }
  return series;
}

FrameRows read_frame_rows(const DoneTask& done, const Measure& measure) {
  const CachedRows cached = read_cached_rows(done.folder, measure);
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
