// The rows a task adds to the tables, kept in its folder: tables/<measure>.csv with the column `frame` (index in
// run.h5) in front. A file is made anew only when it is missing, when what determines it has changed, or when its bytes
// are not those written (tables/keys.json holds both).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jamscape/observe/measure.hpp"
#include "jamscape/study/damage.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

/// The measures a study asks for, in the order of the registry; throws a usage error for an unknown name.
std::vector<const Measure*> chosen_measures(const Study& study);

/// What the leading columns of the tables need: step, time and the two packing fractions. Taken with every measure.
const Measure& instant_measure();
/// The energy ledger of a frame, from which it is marked (ledger.hpp). Taken with every measure.
const Measure& ledger_measure();
/// The same in tables that are all there is: `ledger_error` itself.
const Measure& ledger_error_measure();
/// What ended the relaxation before a frame, as text; taken where frames follow relaxations.
const Measure& relaxation_measure();

enum class Remeasure { missing, all };

/// Those of the study, with the gravity of the system.
MeasureOptions measure_options(const Study& study, std::size_t system);

/// Evaluates the measures on every stored frame of a task that is done. Returns how many measures were computed.
/// `stop` is polled between frames; true leaves the tables as they were. Throws a data error for an unreadable run.h5.
std::size_t measure_task(const TaskFolder& folder, const std::vector<const Measure*>& measures,
                         const MeasureOptions& options, Remeasure what = Remeasure::missing,
                         const std::function<bool()>& stop = {});

/// True when the folder has rows of all these measures.
bool has_rows(const TaskFolder& folder, const std::vector<const Measure*>& measures);

/// measure_task() on all tasks that are done and whole, several at a time, leaving those another process works on
/// alone. Where rows are kept elsewhere, only those that the results lack are taken. Returns the tasks that cannot be
/// used.
std::vector<LeftOut> measure_tasks(const Study& study, const std::vector<Task>& tasks, const ResultPlaces& places,
                                   int jobs, Remeasure what);

/// The cached rows of one measure of one task, as text: lines[f] are the rows of frame f of run.h5 without the leading
/// frame column.
struct CachedRows {
  std::string header;
  std::vector<std::vector<std::string>> lines;
};
CachedRows read_cached_rows(const TaskFolder& folder, const Measure& measure);

/// Fields of a line of numbers; throws a data error naming `file` for anything else.
std::vector<double> read_numbers(std::string_view line, const std::string& file);

}  // namespace jam
