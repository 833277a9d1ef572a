#include "jamscape/study/collected.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "jamscape/base/error.hpp"
#include "jamscape/io/csv.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

std::optional<std::size_t> find_column(const CsvFile& csv, std::string_view name) {
  const auto at = std::find(csv.columns().begin(), csv.columns().end(), name);
  if (at == csv.columns().end()) return std::nullopt;
  return static_cast<std::size_t>(at - csv.columns().begin());
}

std::vector<std::size_t> need_frames(const CsvFile& csv, std::string_view name) {
  const std::optional<std::size_t> column = find_column(csv, name);
  if (!column) throw data_error(fmt::format("the table has no column '{}'", name), csv.file());
  std::vector<std::size_t> out;
  for (const std::int64_t value : csv.integers(*column)) {
    if (value < 0 || value > 100'000'000) throw data_error(fmt::format("{} is no {}", value, name), csv.file());
    out.push_back(static_cast<std::size_t>(value));
  }
  return out;
}

/// Appends to each task its rows of these columns; a column the table lacks is filled with nan. Nothing is appended
/// when it has none of them.
void take_rows(const CsvFile& csv, const Measure& measure, std::map<std::uint64_t, CollectedTask>& tasks) {
  std::vector<std::optional<std::size_t>> columns;
  std::string header;
  for (const ColumnInfo& c : measure.columns) {
    columns.push_back(find_column(csv, c.name));
    header += (header.empty() ? "" : ",") + c.name;
  }
  if (std::none_of(columns.begin(), columns.end(), [](const auto& c) { return c.has_value(); })) return;
  const std::vector<std::size_t> realisation = need_frames(csv, "realisation"), frame = need_frames(csv, "frame");
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    CachedRows& rows = tasks[realisation[row]].rows[measure.name];
    rows.header = header;
    if (rows.lines.size() <= frame[row]) rows.lines.resize(frame[row] + 1);
    std::string line;
    for (const auto& c : columns)
      line.append(&c == &columns.front() ? "" : ",").append(c ? csv.field(row, *c) : std::string_view("nan"));
    rows.lines[frame[row]].push_back(std::move(line));
  }
}

void take_frames(const CsvFile& csv, std::map<std::uint64_t, CollectedTask>& tasks) {
  const std::vector<std::size_t> realisation = need_frames(csv, "realisation"), frame = need_frames(csv, "frame");
  const std::optional<std::size_t> stage = find_column(csv, "stage"), relaxation = find_column(csv, "relaxation"),
                                   target = find_column(csv, "packing_fraction_target");
  if (!stage || !target) throw data_error("the table has no column 'stage' or 'packing_fraction_target'", csv.file());
  const std::vector<double> fraction = csv.numbers(*target);
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    std::vector<PlannedFrame>& frames = tasks[realisation[row]].frames;
    if (frames.size() != frame[row])
      throw data_error(fmt::format("frame {} stands where frame {} is expected", frame[row], frames.size()),
                       csv.place(row, 0));
    const bool relaxed = relaxation && !csv.field(row, *relaxation).empty();
    frames.push_back({std::string(csv.field(row, *stage)), fraction[row], -1, relaxed});
  }
}

}  // namespace

bool is_collected(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder / "tasks", error)) return false;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().filename().string().ends_with(".csv.gz")) return true;
  return false;
}

std::map<std::uint64_t, CollectedTask> read_collected(const fs::path& folder, const std::string& system,
                                                      const std::vector<const Measure*>& measures) {
  std::map<std::uint64_t, CollectedTask> tasks;
  std::error_code ignored;
  const fs::path file = folder / (system + ".csv.gz");
  if (!fs::exists(file, ignored)) return tasks;
  const CsvFile frames = CsvFile::read(file);
  take_frames(frames, tasks);
  take_rows(frames, instant_measure(), tasks);
  take_rows(frames, relaxation_measure(), tasks);
  take_rows(frames, ledger_error_measure(), tasks);
  for (const Measure* m : measures) {
    const fs::path own = folder / fmt::format("{}.{}.csv.gz", system, m->name);
    if (m->rows == Rows::frame)
      take_rows(frames, *m, tasks);
    else if (fs::exists(own, ignored))
      take_rows(CsvFile::read(own), *m, tasks);
  }
  return tasks;
}

}  // namespace jam
