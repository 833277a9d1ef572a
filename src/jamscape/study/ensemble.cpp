#include "jamscape/study/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "jamscape/base/files.hpp"
#include "jamscape/study/averaging.hpp"
#include "jamscape/study/tables.hpp"

namespace jam {
namespace {

std::string print(const Moments& m, std::size_t marked) {
  return fmt::format("{},{},{},{},{}\n", m.n, m.mean, m.sd, m.se, marked);
}

/// How many realisations have this frame marked.
std::size_t marked_runs(const std::vector<const DoneTask*>& done, std::size_t frame) {
  return static_cast<std::size_t>(std::count_if(
      done.begin(), done.end(), [frame](const DoneTask* d) { return frame < d->marked.size() && d->marked[frame]; }));
}

/// One value per realisation, of one frame.
std::vector<double> at_frame(const std::vector<std::vector<double>>& runs, std::size_t frame) {
  std::vector<double> values;
  for (const std::vector<double>& run : runs) values.push_back(run[frame]);
  return values;
}

std::string frames_text(const Study& study, const std::vector<std::vector<const DoneTask*>>& systems,
                        const std::vector<const Measure*>& measures, const VariedColumns& varied) {
  std::string text = "system" + varied.header + ",frame,packing_fraction_target,quantity,n,mean,sd,se,marked\n";
  for (std::size_t s = 0; s < systems.size(); ++s) {
    const FrameSeries series = read_frame_series(systems[s], measures);
    for (std::size_t f = 0; f < series.target.size(); ++f) {
      const std::string leading =
          fmt::format("{}{},{},{}", csv_field(study.systems[s].name), varied.of_system[s], f, series.target[f]);
      for (std::size_t q = 0; q < series.quantity.size(); ++q)
        text += fmt::format("{},{},{}", leading, series.quantity[q],
                            print(average(at_frame(series.value[q], f), series.averaging[q]), series.marked[f]));
      for (const Measure* m : measures)
        for (const PooledRatio& ratio : m->ratios)
          if (m->rows == Rows::frame && series.realisations > 0)
            text += fmt::format(
                "{},{},{}", leading, ratio.name,
                print(pooled_ratio(at_frame(*series.find(ratio.over), f), at_frame(*series.find(ratio.under), f)),
                      series.marked[f]));
    }
  }
  return text;
}

/// Rows of one frame with equal abscissae, over the realisations: [abscissae][quantity][realisation].
using Bins = std::map<std::vector<double>, std::vector<std::vector<double>>>;

std::string measure_text(const Study& study, const std::vector<std::vector<const DoneTask*>>& systems,
                         const Measure& measure, const VariedColumns& varied) {
  const auto abscissae = static_cast<std::size_t>(measure.abscissae);
  std::string text = "system" + varied.header + ",frame,packing_fraction_target";
  for (std::size_t c = 0; c < abscissae; ++c) text += fmt::format(",{}", measure.columns[c].name);
  text += ",quantity,n,mean,sd,se,marked\n";
  for (std::size_t s = 0; s < systems.size(); ++s) {
    std::vector<FrameRows> runs;
    for (const DoneTask* d : systems[s]) runs.push_back(read_frame_rows(*d, measure));
    for (std::size_t f = 0; !runs.empty() && f < runs.front().size(); ++f) {
      Bins bins;
      for (std::size_t r = 0; r < runs.size(); ++r) {
        const FrameRows& run = runs[r];
        if (f >= run.size() || systems[s][r]->left_out[f]) continue;
        for (const std::vector<double>& row : run[f]) {
          const auto split = row.begin() + static_cast<std::ptrdiff_t>(abscissae);
          auto& bin = bins[{row.begin(), split}];
          bin.resize(row.size() - abscissae);
          for (std::size_t q = 0; q < bin.size(); ++q) bin[q].push_back(row[abscissae + q]);
        }
      }
      const std::string frame = fmt::format("{}{},{},{}", csv_field(study.systems[s].name), varied.of_system[s], f,
                                            systems[s].front()->frames[f].packing_fraction);
      const std::size_t marked = marked_runs(systems[s], f);
      for (const auto& bin : bins) {
        const auto& [at, quantities] = bin;
        std::string leading = frame;
        for (const double a : at) leading += fmt::format(",{}", a);
        const auto values = [&](const std::string& column) -> const std::vector<double>& {
          std::size_t q = 0;
          while (measure.columns[abscissae + q].name != column) ++q;
          return bin.second[q];
        };
        for (std::size_t q = 0; q < quantities.size(); ++q) {
          const ColumnInfo& column = measure.columns[abscissae + q];
          text +=
              fmt::format("{},{},{}", leading, column.name, print(average(quantities[q], column.averaging), marked));
        }
        for (const PooledRatio& ratio : measure.ratios)
          text += fmt::format("{},{},{}", leading, ratio.name,
                              print(pooled_ratio(values(ratio.over), values(ratio.under)), marked));
      }
    }
  }
  return text;
}

}  // namespace

void write_ensemble(const Study& study, const std::vector<DoneTask>& done, const std::filesystem::path& results) {
  const VariedColumns varied = varied_columns(study);
  const auto systems = by_system(study, done);
  const std::vector<const Measure*> chosen = measured(study, done);
  make_folder(results / "ensemble");
  write_text(results / "ensemble" / "frames.csv", frames_text(study, systems, chosen, varied));
  for (const Measure* m : chosen)
    if (m->rows == Rows::many && m->averaged)
      write_text(results / "ensemble" / (m->name + ".csv"), measure_text(study, systems, *m, varied));
}

}  // namespace jam
