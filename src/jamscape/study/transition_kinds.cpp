#include "jamscape/study/transition_kinds.hpp"

namespace jam {
namespace {

constexpr std::string_view not_reached = "not reached";
constexpr std::string_view no_inflection = "no fit: too few states, or no inflection among them";
constexpr std::string_view no_state = "no rho_j, or no state above it";
constexpr std::string_view no_tail = "no fit: no tail beyond the mean force";
constexpr std::string_view no_law = "no fit: no such law comes closest to P(f)";
constexpr std::string_view no_peak = "no such peak stands out";

constexpr TransitionKind kinds[] = {
    // where a system jams, by every reading of "Z reaches 3" that theory sec. 6a lists
    {"rho_c", "last upward crossing of the ensemble-mean z at 3, linear interpolation; error by jackknife",
     "S1 Table I", not_reached, true},
    {"rho_c_walls", "rho_c with z_walls: wall contacts counted too", "theory sec. 6a", not_reached, true},
    {"rho_c_multi", "rho_c with z_multi: over grains with two contacts or more", "theory sec. 6a", not_reached, true},
    {"rho_c_plain", "rho_c on the axis of packing_fraction_plain", "theory sec. 6a", not_reached, true},
    {"rho_inflection", "inflection of the mean z: logistic plus line around rho_c; error by bootstrap",
     "theory sec. 6a", no_inflection, true},
    {"rho_c_single", "mean over the realisations of their own crossings of z = 3", "theory sec. 6a", not_reached, true},
    // at a chosen contact number, and where pressure sets in
    {"rho_z", "rho_c at the contact number of option jamming_z instead of 3; error by jackknife", "theory sec. 4",
     not_reached, true},
    {"rho_z_multi", "rho_z with z_multi: over grains with two contacts or more", "theory sec. 4", not_reached, true},
    {"rho_pressure",
     "onset of pressure: last upward crossing of the ensemble-mean pressure at option jamming_pressure; error by "
     "jackknife",
     "theory sec. 4", not_reached, true},
    {"rho_pressure_zero",
     "where the pressure above its onset comes from 0: line through p (linear contacts) or p^(2/3) (Hertz) of the mean "
     "curve from jamming_pressure to a hundred times that; error by jackknife",
     "theory sec. 4", "no fit: fewer than three states between the two pressures", true},
    // where frames follow relaxations; only those frames count then, for all rows
    {"rho_j", "inflection of the whole mean z with different slopes below and above; error by bootstrap", "S2 Sec. 4",
     no_inflection, true},
    {"z_at_rho_j", "the fitted z at rho_j, half way up the jump; error by bootstrap", "S2 Sec. 4", no_inflection},
    {"z_above", "mean z at the first state above rho_j", "S2 Sec. 4", no_state},
    {"rho_j_backbone", "rho_j of z_backbone (rattlers removed)", "S2 Sec. 4", no_inflection, true},
    {"z_backbone_at_rho_j", "the fitted z_backbone at its inflection", "S2 Sec. 4", no_inflection},
    {"z_backbone_above", "mean z_backbone at the first state above rho_j", "S2 Sec. 4", no_state},
    {"rho_p",
     "first state from which on a realisation percolates, mean over the realisations; error: theirs and, in "
     "quadrature, what the distance h of the states there leaves open, h/sqrt(12)",
     "S2 Sec. 4", not_reached, true},
    // of the histograms of all realisations added up, at the last state
    {"tail_k_pooled",
     "exponent k of P(f) ~ exp(-k f) for f > 1, least squares with a free prefactor; error by jackknife over the "
     "realisations, of a single one by the counts",
     "S3 Eq. 2", no_tail},
    {"tail_k_loglinear_pooled", "the same from a line through ln P", "theory sec. 4", no_tail},
    {"peak_position_pooled",
     "centre of the highest bin of P(f) beyond f = .3; error: jackknife and, in quadrature, width of the bin/sqrt(12)",
     "S3 Fig. 5", "no forces beyond f = .3"},
    {"peak_prominence_pooled", "P there less P of the lowest bin before it; counting error", "S3 Fig. 5",
     "no forces beyond f = .3"},
    {"type_a_pooled", "1 where that peak stands out by more than two errors (type A), 0 where P(f) is of type B",
     "S3 Fig. 1", "no forces"},
    {"bend_pooled",
     "c of ln P = a + b f + c f^2 on .2 < f < 2: below 0 where P(f) has a peak or a shoulder, 0 for an exponential; "
     "counting error",
     "theory sec. 4", "no fit: fewer than four bins between .2 and 2 hold a force"},
    {"mueth_a_pooled", "a of Mueth's law a (1 - b exp(-f^2)) exp(-beta f) fitted to P(f)", "S3 Eq. 1", no_law},
    {"mueth_b_pooled", "b of Mueth's law", "S3 Eq. 1", no_law},
    {"mueth_beta_pooled", "beta of Mueth's law", "S3 Eq. 1", no_law},
    {"force_contacts_pooled", "contacts behind P(f)", "S3 Data analysis", "no forces"},
    {"rdf_peak1_pooled", "position of the first peak of G(r), in L; error by bootstrap", "S3 Table 2", no_peak},
    {"rdf_peak2_pooled", "position of the second peak of G(r), in L; error by bootstrap", "S3 Table 2", no_peak},
    {"rdf_peak3_pooled", "position of the third peak of G(r), in L; error by bootstrap", "S3 Table 2", no_peak},
};

}  // namespace

std::span<const TransitionKind> transition_kinds() { return kinds; }

std::string_view why_missing(std::string_view quantity) {
  for (const TransitionKind& kind : kinds)
    if (kind.name == quantity) return kind.missing;
  return not_reached;
}

}  // namespace jam
