#include "jamscape/study/pooled_forces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "jamscape/stats/curves.hpp"
#include "jamscape/stats/force_tail.hpp"
#include "jamscape/stats/shell_peaks.hpp"

namespace jam {
namespace {

using Curves = std::vector<std::vector<double>>;

constexpr std::size_t resamples = 200;

/// Columns of a measure at one frame, of each realisation; the abscissa is that of the first.
struct Histograms {
  std::vector<double> centre;
  Curves over, under;
  std::vector<std::size_t> run;  ///< of each curve
};

std::size_t column(const Measure& measure, std::string_view name) {
  const auto at =
      std::find_if(measure.columns.begin(), measure.columns.end(), [&](const ColumnInfo& c) { return c.name == name; });
  return static_cast<std::size_t>(at - measure.columns.begin());
}

/// Nothing where the measure was not taken; realisations with other bins than the first are left out.
Histograms histograms(const std::vector<const DoneTask*>& done, const std::vector<const Measure*>& measures,
                      std::string_view name, std::string_view over, std::string_view under, std::size_t frame) {
  Histograms h;
  const auto at = std::find_if(measures.begin(), measures.end(), [&](const Measure* m) { return m->name == name; });
  if (at == measures.end()) return h;
  const std::size_t a = column(**at, over), b = column(**at, under);
  for (std::size_t run = 0; run < done.size(); ++run) {
    const DoneTask* d = done[run];
    const FrameRows rows = read_frame_rows(*d, **at);
    if (frame >= rows.size() || rows[frame].empty() || d->left_out[frame]) continue;
    std::vector<double> centre, top, bottom;
    for (const std::vector<double>& row : rows[frame])
      centre.push_back(row[0]), top.push_back(row[a]), bottom.push_back(row[b]);
    if (h.centre.empty()) h.centre = centre;
    if (h.centre != centre) continue;
    h.over.push_back(std::move(top)), h.under.push_back(std::move(bottom));
    h.run.push_back(run);
  }
  return h;
}

void add_forces(const Histograms& h, std::vector<Transition>& found) {
  const std::size_t n = h.over.size();
  if (n == 0) return;
  std::vector<std::size_t> all(n);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto tail = [&](std::span<const std::size_t> which) {
    return force_tail(h.centre, sum_of_curves(h.over, which), sum_of_curves(h.under, which));
  };
  const ForceTail pooled = tail(all);
  const auto add = [&](const char* name, double alone, const std::function<double(const ForceTail&)>& read) {
    const Estimate e = jackknife(n, [&](std::span<const std::size_t> which) { return read(tail(which)); });
    found.push_back({name, n, e.value, n > 1 ? e.error : alone});
  };
  const double none = std::nan("");
  add("tail_k_pooled", pooled.exponent.error, [](const ForceTail& t) { return t.exponent.value; });
  add("tail_k_loglinear_pooled", pooled.loglinear.error, [](const ForceTail& t) { return t.loglinear.value; });
  const double width = h.centre.size() > 1 ? h.centre[1] - h.centre[0] : none;
  add("peak_position_pooled", none, [](const ForceTail& t) { return t.peak.position; });
  found.back().se = std::hypot(found.back().se, width / std::sqrt(12.0));
  found.push_back({"peak_prominence_pooled", n, pooled.peak.prominence, pooled.peak.error});
  found.push_back({"type_a_pooled", n, pooled.type_a() ? 1.0 : 0.0, none});
  found.push_back({"bend_pooled", n, pooled.bend.value, pooled.bend.error});
  add("mueth_a_pooled", none, [](const ForceTail& t) { return t.mueth.a; });
  add("mueth_b_pooled", none, [](const ForceTail& t) { return t.mueth.b; });
  add("mueth_beta_pooled", none, [](const ForceTail& t) { return t.mueth.beta; });
  const std::vector<double> norm = sum_of_curves(h.under, all);
  found.push_back({"force_contacts_pooled", n, norm.empty() ? none : std::round(norm.front() / width), none});
}

void add_peaks(const Histograms& h, const FrameSeries& series, std::size_t frame, Random random,
               std::vector<Transition>& found) {
  if (h.over.empty()) return;
  const std::array<Estimate, 3> peaks = shell_peaks(h.centre, h.over, h.under, resamples, random);
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    const std::string name = "rdf_peak" + std::to_string(k + 1);
    double error = peaks[k].error;
    const auto* alone = series.find(name + "_error");
    if (h.over.size() == 1 && alone) error = (*alone)[h.run[0]][frame];
    found.push_back({name + "_pooled", peaks[k].n, peaks[k].value, error});
  }
}

}  // namespace

std::vector<Transition> pooled_forces(const std::vector<const DoneTask*>& done,
                                      const std::vector<const Measure*>& measures, const FrameSeries& series,
                                      std::uint64_t seed, const std::string& key) {
  std::vector<Transition> found;
  const std::vector<std::size_t> states = series.states();
  if (done.empty() || states.empty()) return found;
  const std::size_t last = states.back();
  add_forces(histograms(done, measures, "contact_force_distribution", "count", "norm", last), found);
  add_peaks(histograms(done, measures, "radial_distribution", "pairs", "ideal", last), series, last,
            Random(seed, key, 0, "bootstrap of the peaks"), found);
  return found;
}

}  // namespace jam
