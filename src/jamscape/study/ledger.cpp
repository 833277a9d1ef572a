#include "jamscape/study/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/protocol/ledger.hpp"

namespace jam {

std::vector<double> ledger_errors(const Study& study, const DoneTask& done) {
  std::vector<double> errors(done.stored.size(), std::numeric_limits<double>::quiet_NaN());
  if (done.collected) {
    const Measure& measure = ledger_error_measure();
    if (!done.collected->rows.contains(measure.name)) return errors;
    const FrameRows rows = read_frame_rows(done, measure);
    for (std::size_t f = 0; f < errors.size(); ++f)
      if (!rows[f].empty()) errors[f] = rows[f][0].at(0);
    return errors;
  }
  if (!has_rows(done.folder, {&ledger_measure()})) return errors;
  const FrameRows rows = read_frame_rows(done, ledger_measure());
  const LedgerStart start = ledger_start(study.systems[done.task->system].options, done.task->key);
  for (std::size_t f = 0; f < errors.size(); ++f)
    errors[f] = ledger_error(rows[f].at(0).at(0), rows[f].at(0).at(1), start);
  return errors;
}

MarkedFrames count_marked(const std::vector<const DoneTask*>& done) {
  MarkedFrames found;
  for (const DoneTask* d : done) {
    bool any = false;
    for (std::size_t f = 0; f < d->marked.size(); ++f) {
      if (!d->marked[f]) continue;
      const double rho = d->frames[f].packing_fraction;
      found.from = found.frames == 0 ? rho : std::min(found.from, rho);
      found.worst = std::max(found.worst, d->ledger_error[f]);
      ++found.frames, any = true;
    }
    found.runs += any;
  }
  return found;
}

}  // namespace jam
