#include "jamscape/study/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/io/aside.hpp"
#include "jamscape/study/measure_task.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

/// A file written piece by piece beside its place, and renamed when whole.
class TableFile {
 public:
  explicit TableFile(const fs::path& path) : aside_(path), out_(aside_.path(), std::ios::binary | std::ios::trunc) {}

  void add(std::string_view text) { out_.write(text.data(), static_cast<std::streamsize>(text.size())); }
  void finish() {
    out_.close();
    if (!out_) throw data_error("cannot write a table", aside_.path().string(), "make room on the disk and run again");
    aside_.commit();
  }

 private:
  Aside aside_;
  std::ofstream out_;
};

/// A task that is done, with what stands in front of its rows.
struct LedTask {
  const DoneTask* done;
  std::vector<std::string> leading;
};

std::vector<LedTask> lead(const Study& study, const std::vector<DoneTask>& done, const VariedColumns& varied) {
  std::vector<LedTask> led;
  const bool with_relaxation = relaxes(study);
  for (const DoneTask& d : done) {
    const Task& task = *d.task;
    const CachedRows instants = read_rows(d, instant_measure());
    const std::vector<std::string> relaxation = relaxations(d);
    LedTask t{&d, {}};
    for (std::size_t f = 0; f < d.stored.size(); ++f) {
      const std::string& instant = instants.lines.at(d.stored[f]).at(0);
      const std::size_t time = instant.find(',') + 1, fraction = instant.find(',', time);
      t.leading.push_back(fmt::format("{},{}{},{},{}{},{},{}{}", csv_field(study.systems[task.system].name),
                                      task.realisation, varied.of_system[task.system], f, csv_field(d.frames[f].stage),
                                      with_relaxation ? "," + relaxation[f] : "", instant.substr(0, fraction),
                                      d.frames[f].packing_fraction, instant.substr(fraction)) +
                          (std::isnan(d.ledger_error[f]) ? ",nan"
                           : d.marked[f]                 ? ",1"
                                                         : ",0"));
    }
    led.push_back(std::move(t));
  }
  return led;
}

std::string leading_header(const Study& study, const VariedColumns& varied) {
  return fmt::format(
      "system,realisation{},frame,stage{},step,time,packing_fraction_target,packing_fraction,packing_fraction_plain,"
      "marked",
      varied.header, relaxes(study) ? ",relaxation" : "");
}

void write_frames_table(const std::vector<LedTask>& done, const std::vector<const Measure*>& per_frame,
                        const std::string& header, const fs::path& path) {
  TableFile file(path);
  std::string line = header + ",ledger_error";
  for (const Measure* m : per_frame)
    for (const ColumnInfo& c : m->columns) line += "," + c.name;
  file.add(line + "\n");
  for (const LedTask& led : done) {
    const DoneTask& d = *led.done;
    std::vector<CachedRows> rows;
    for (const Measure* m : per_frame) rows.push_back(read_rows(d, *m));
    for (std::size_t f = 0; f < d.stored.size(); ++f) {
      line = fmt::format("{},{}", led.leading[f], d.ledger_error[f]);
      for (std::size_t k = 0; k < per_frame.size(); ++k) {
        const auto& lines = rows[k].lines;
        if (d.stored[f] >= lines.size() || lines[d.stored[f]].size() != 1)
          throw data_error(fmt::format("frame {} of the measure '{}' is missing", f, per_frame[k]->name),
                           d.folder.tables().string(), "jamscape measure DIR --again");
        line.append(1, ',').append(lines[d.stored[f]].front());
      }
      file.add(line + "\n");
    }
  }
  file.finish();
}

/// False where no frame has rows.
bool write_measure_table(const std::vector<LedTask>& done, const Measure& measure, const std::string& header,
                         const fs::path& path) {
  TableFile file(path);
  bool any = false;
  std::string line = header;
  for (const ColumnInfo& c : measure.columns) line += "," + c.name;
  file.add(line + "\n");
  for (const LedTask& led : done) {
    const DoneTask& d = *led.done;
    const CachedRows rows = read_rows(d, measure);
    for (std::size_t f = 0; f < d.stored.size(); ++f) {
      if (d.stored[f] >= rows.lines.size()) continue;
      for (const std::string& values : rows.lines[d.stored[f]])
        file.add(led.leading[f] + "," + values + "\n"), any = true;
    }
  }
  file.finish();
  return any;
}

}  // namespace

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  quoted += '"';
  return quoted;
}

VariedColumns varied_columns(const Study& study) {
  VariedColumns varied;
  varied.of_system.resize(study.systems.size());
  for (const std::string& key : varied_options(study)) {
    varied.header += "," + key;
    for (std::size_t s = 0; s < study.systems.size(); ++s) {
      SystemOptions options = study.systems[s].options;
      for (const Option& o : system_options(options)) {
        if (o.key != key) continue;
        if (const auto* number = std::get_if<double*>(&o.target)) {
          varied.of_system[s] += fmt::format(",{}", **number);
          continue;
        }
        std::string value = print_value(o);
        if (value.size() >= 2 && value.front() == '"') value = value.substr(1, value.size() - 2);
        varied.of_system[s] += fmt::format(",{}", csv_field(value));
      }
    }
  }
  return varied;
}

std::vector<std::string> write_tables(const Study& study, const std::vector<DoneTask>& done_tasks,
                                      const fs::path& results) {
  const VariedColumns varied = varied_columns(study);
  const std::vector<const Measure*> chosen = measured(study, done_tasks);
  const std::vector<LedTask> done = lead(study, done_tasks, varied);
  const std::string header = leading_header(study, varied);
  make_folder(results / "tables");
  std::vector<const Measure*> per_frame;
  std::vector<std::string> empty;
  for (const Measure* m : chosen)
    if (m->rows == Rows::frame)
      per_frame.push_back(m);
    else if (!write_measure_table(done, *m, header, results / "tables" / (m->name + ".csv")))
      empty.push_back(m->name);
  write_frames_table(done, per_frame, header, results / "tables" / "frames.csv");
  for (const Measure& m : measures()) {
    if (m.rows == Rows::frame || std::find(chosen.begin(), chosen.end(), &m) != chosen.end()) continue;
    std::error_code ignored;
    fs::remove(results / "tables" / (m.name + ".csv"), ignored);
    fs::remove(results / "ensemble" / (m.name + ".csv"), ignored);
  }
  return done.empty() ? std::vector<std::string>{} : empty;
}

}  // namespace jam
