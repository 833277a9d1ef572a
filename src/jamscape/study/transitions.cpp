#include "jamscape/study/transitions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "jamscape/base/border.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/stats/crossing.hpp"
#include "jamscape/stats/curves.hpp"
#include "jamscape/stats/inflection.hpp"
#include "jamscape/stats/moments.hpp"
#include "jamscape/stats/none.hpp"
#include "jamscape/study/identity.hpp"
#include "jamscape/study/pooled_forces.hpp"
#include "jamscape/study/tables.hpp"
#include "jamscape/study/transition_kinds.hpp"

namespace jam {
namespace {

using Curves = std::vector<std::vector<double>>;

constexpr double jammed_z = 3;       // S1's criterion
constexpr double fit_range = 0.05;   // how far from rho_c the fit of the inflection looks
constexpr double onset_range = 100;  // pressures, in those of the onset, that its line looks at
constexpr std::size_t resamples = 200;

/// Stages that follow each other may both have a frame at the same packing fraction; a curve has it once.
std::vector<std::size_t> increasing(const std::vector<double>& x) {
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (kept.empty() || x[k] > x[kept.back()]) kept.push_back(k);
  return kept;
}

std::vector<double> pick(const std::vector<double>& values, const std::vector<std::size_t>& which) {
  std::vector<double> picked;
  for (const std::size_t k : which) picked.push_back(values[k]);
  return picked;
}

Curves pick(const Curves& curves, const std::vector<std::size_t>& which) {
  Curves picked;
  for (const std::vector<double>& c : curves) picked.push_back(pick(c, which));
  return picked;
}

Transition from_estimate(std::string quantity, const Estimate& e) {
  return {std::move(quantity), e.n, e.value, e.error};
}

Transition plain(const Curves& z, const Curves& fraction) {
  const Estimate e = jackknife(z.size(), [&](std::span<const std::size_t> runs) {
    const std::vector<double> x = mean_curve(fraction, runs);
    return last_upward_crossing(x, mean_curve(z, runs), jammed_z).value_or(none);
  });
  return from_estimate("rho_c_plain", e);
}

Transition single(const std::vector<double>& x, const Curves& z) {
  std::vector<double> crossings;
  for (const std::vector<double>& run : z)
    if (const auto c = last_upward_crossing(x, run, jammed_z)) crossings.push_back(*c);
  const Moments m = moments(crossings);
  return {"rho_c_single", m.n, m.mean, m.se};
}

Transition inflection(const std::vector<double>& x, const Curves& z, double rho_c, std::uint64_t seed,
                      const std::string& key) {
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (!std::isfinite(rho_c) || std::abs(x[k] - rho_c) <= fit_range) near.push_back(k);
  Random random(seed, key, 0, "bootstrap of the inflection");
  return from_estimate("rho_inflection", inflection_of_mean(pick(x, near), pick(z, near), resamples, random));
}

/// S2's jamming: inflection of the whole curve, contact number there and at the first state above.
void add_jamming(const std::string& rho_name, const std::string& z_name, const std::vector<double>& x, const Curves& z,
                 std::uint64_t seed, const std::string& key, std::vector<Transition>& found) {
  const auto random = [&] { return Random(seed, key, 0, "bootstrap of the inflection"); };
  Random first = random(), second = random();
  const Estimate rho = inflection_of_mean(x, z, resamples, first, Slopes::different);
  found.push_back(from_estimate(rho_name, rho));
  found.push_back(from_estimate(z_name + "_at_rho_j",
                                bootstrap(z.size(), resamples, second, [&](std::span<const std::size_t> which) {
                                  const auto bend = fit_inflection(x, mean_curve(z, which), Slopes::different);
                                  return bend ? bend->y : none;
                                })));
  const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), rho.value) - x.begin());
  std::vector<double> values;
  if (std::isfinite(rho.value) && above < x.size())
    for (const std::vector<double>& run : z) values.push_back(run[above]);
  const Moments m = moments(values);
  found.push_back({z_name + "_above", m.n, m.mean, m.se});
}

/// Where the mean pressure, to the power that makes it a line above jamming, comes from 0.
Transition pressure_from_zero(const std::vector<double>& x, const Curves& pressure, const Jamming& at) {
  const Estimate e = jackknife(pressure.size(), [&](std::span<const std::size_t> runs) {
    const std::vector<double> p = mean_curve(pressure, runs);
    std::size_t first = p.size();  // the states after the last one below the onset
    while (first > 0 && reaches(p[first - 1], at.pressure)) --first;
    std::vector<double> rho, root;
    for (std::size_t k = first; k < p.size() && !exceeds(p[k], onset_range * at.pressure); ++k)
      rho.push_back(x[k]), root.push_back(std::pow(p[k], 1 / at.pressure_exponent));
    if (rho.size() < 3) return none;
    const Moments mean_rho = moments(rho), mean_root = moments(root);
    double xx = 0, xy = 0;
    for (std::size_t k = 0; k < rho.size(); ++k)
      xx += (rho[k] - mean_rho.mean) * (rho[k] - mean_rho.mean), xy += (rho[k] - mean_rho.mean) * root[k];
    return xy > 0 ? mean_rho.mean - mean_root.mean * xx / xy : none;
  });
  return from_estimate("rho_pressure_zero", e);
}

Transition percolation(const std::vector<double>& x, const Curves& percolates) {
  std::vector<double> onsets, gaps;
  for (const std::vector<double>& run : percolates) {
    std::size_t first = run.size();
    while (first > 0 && run[first - 1] > 0) --first;
    if (first < run.size()) onsets.push_back(x[first]), gaps.push_back(first > 0 ? x[first] - x[first - 1] : 0);
  }
  const Moments m = moments(onsets);
  return {"rho_p", m.n, m.mean, std::hypot(m.se, moments(gaps).mean / std::sqrt(12.0))};
}

/// Made of these states, where z is known.
std::vector<Transition> find_among(const FrameSeries& series, const std::vector<std::size_t>& kept, const Jamming& at,
                                   std::uint64_t seed, const std::string& key) {
  const Curves* z = series.find("z");
  const std::vector<double> x = pick(series.target, kept);
  const Curves zs = pick(*z, kept);
  std::vector<Transition> found;
  found.push_back(from_estimate("rho_c", crossing_of_mean(x, zs, jammed_z)));
  const double rho_c = found.front().value;
  for (const auto& [column, name] : {std::pair{"z_walls", "rho_c_walls"}, std::pair{"z_multi", "rho_c_multi"}})
    if (const Curves* other = series.find(column))
      found.push_back(from_estimate(name, crossing_of_mean(x, pick(*other, kept), jammed_z)));
  if (const Curves* fraction = series.find("packing_fraction_plain")) found.push_back(plain(zs, pick(*fraction, kept)));
  found.push_back(inflection(x, zs, rho_c, seed, key));
  found.push_back(single(x, zs));
  found.push_back(from_estimate("rho_z", crossing_of_mean(x, zs, at.z)));
  if (const Curves* multi = series.find("z_multi"))
    found.push_back(from_estimate("rho_z_multi", crossing_of_mean(x, pick(*multi, kept), at.z)));
  if (const Curves* pressure = series.find("pressure")) {
    const Curves p = pick(*pressure, kept);
    found.push_back(from_estimate("rho_pressure", crossing_of_mean(x, p, at.pressure)));
    found.push_back(pressure_from_zero(x, p, at));
  }
  if (!series.relaxed()) return found;
  add_jamming("rho_j", "z", x, zs, seed, key, found);
  if (const Curves* backbone = series.find("z_backbone"))
    add_jamming("rho_j_backbone", "z_backbone", x, pick(*backbone, kept), seed, key, found);
  if (const Curves* percolates = series.find("percolates")) found.push_back(percolation(x, pick(*percolates, kept)));
  return found;
}

}  // namespace

std::string why_missing(const Transition& t) {
  const std::string_view why = why_missing(t.quantity);
  if (t.left_out == 0) return std::string(why);
  return fmt::format("marked: {} states are left out, whose energy ledger is off; of the others {}", t.left_out, why);
}

std::vector<Transition> find_jamming(const FrameSeries& series, const Jamming& at, std::uint64_t seed,
                                     const std::string& key) {
  if (!series.find("z") || series.realisations == 0 || series.target.empty()) return {};
  const std::vector<std::size_t> states = series.states(), rising = increasing(pick(series.target, states));
  std::vector<std::size_t> kept;
  for (const std::size_t k : rising)
    if (series.left_out.empty() || !series.left_out[states[k]]) kept.push_back(states[k]);
  if (kept.empty()) return {};
  std::vector<Transition> found = find_among(series, kept, at, seed, key);
  for (Transition& t : found) t.left_out = rising.size() - kept.size();
  return found;
}

std::vector<Transition> find_transitions(const Study& study, std::size_t system,
                                         const std::vector<const DoneTask*>& done,
                                         const std::vector<const Measure*>& measures, const FrameSeries& series) {
  const SystemOptions& options = study.systems[system].options;
  const auto seed = static_cast<std::uint64_t>(study.info.seed);
  const std::string key = physics_key(options);
  std::vector<Transition> found;
  const Jamming at{study.measure.jamming_z, study.measure.jamming_pressure, hertzian(options.contact.law) ? 1.5 : 1.0};
  if (plans_packing_fraction(options)) found = find_jamming(series, at, seed, key);
  for (Transition& t : pooled_forces(done, measures, series, seed, key)) found.push_back(std::move(t));
  return found;
}

std::vector<std::vector<Transition>> write_transitions(const Study& study, const std::vector<DoneTask>& done,
                                                       const std::filesystem::path& results) {
  const VariedColumns varied = varied_columns(study);
  const auto systems = by_system(study, done);
  const std::vector<const Measure*> measures = measured(study, done);
  std::vector<std::vector<Transition>> all;
  std::string text = "system" + varied.header + ",quantity,n,value,se,marked\n";
  for (std::size_t s = 0; s < systems.size(); ++s) {
    const FrameSeries series = read_frame_series(systems[s], measures);
    all.push_back(find_transitions(study, s, systems[s], measures, series));
    std::size_t marked = 0;
    if (study.info.ledger == LedgerRule::open)
      for (const std::size_t f : series.states()) marked += series.marked[f];
    for (const Transition& t : all.back())
      text += fmt::format("{}{},{},{},{},{},{}\n", csv_field(study.systems[s].name), varied.of_system[s], t.quantity,
                          t.n, t.value, t.se, marked);
  }
  make_folder(results / "ensemble");
  write_text(results / "ensemble" / "transitions.csv", text);
  return all;
}

}  // namespace jam
