// DIR/tables/*.csv: all tasks' rows side by side, tidy. Leading columns
//
//   system, realisation, <options that differ between systems>, frame, stage, [relaxation,] step, time,
//   packing_fraction_target, packing_fraction, packing_fraction_plain, marked
//
// `relaxation` is there in studies that relax: what ended it before the frame, fluctuation, energy or budget (not
// relaxed); empty where there was none.
// `marked` is 1 where the energy ledger is off by more than study.ledger_mark (ledger.hpp; `ledger_error` in
// frames.csv says by how much), nan where that is not known;
// then the measure's. Measures of one row a frame share `frames.csv`; the others have a file of their own. `frame` is
// the index in the plan, `realisation` counts from 0. Only tasks that are done appear, in the order of the study.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

/// Measures what is missing has been done before (measure_task.hpp). Tables of measures no longer wanted are removed.
/// Returns the measures of several rows a frame whose table stays without rows.
std::vector<std::string> write_tables(const Study& study, const std::vector<DoneTask>& done,
                                      const std::filesystem::path& results);

/// The values of the varied options of each system, as CSV fields with a comma in front of each; `header` likewise.
struct VariedColumns {
  std::string header;
  std::vector<std::string> of_system;
};
VariedColumns varied_columns(const Study& study);

/// A CSV field: quoted where it must be (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace jam
