#include "jamscape/study/transition_kinds.hpp"

namespace jam {
namespace {

constexpr TransitionKind kinds[] = {
    // where a system jams, by every reading of "Z reaches 3" that theory sec. 6a lists
    {"rho_c", "last upward crossing of the ensemble-mean z at 3, linear interpolation; error by jackknife",
     "S1 Table I", true},
    {"rho_c_walls", "rho_c with z_walls: wall contacts counted too", "theory sec. 6a", true},
    {"rho_c_multi", "rho_c with z_multi: over grains with two contacts or more", "theory sec. 6a", true},
    {"rho_c_plain", "rho_c on the axis of packing_fraction_plain", "theory sec. 6a", true},
    {"rho_inflection", "inflection of the mean z: logistic plus line around rho_c; error by bootstrap",
     "theory sec. 6a", true},
    {"rho_c_single", "mean over the realisations of their own crossings of z = 3", "theory sec. 6a", true},
    // where frames follow relaxations; only those frames count then, for all rows
    {"rho_j", "inflection of the whole mean z with different slopes below and above; error by bootstrap", "S2 Sec. 4",
     true},
    {"z_at_rho_j", "the fitted z at rho_j, half way up the jump; error by bootstrap", "S2 Sec. 4"},
    {"z_above", "mean z at the first state above rho_j", "S2 Sec. 4"},
    {"rho_j_backbone", "rho_j of z_backbone (rattlers removed)", "S2 Sec. 4", true},
    {"z_backbone_at_rho_j", "the fitted z_backbone at its inflection", "S2 Sec. 4"},
    {"z_backbone_above", "mean z_backbone at the first state above rho_j", "S2 Sec. 4"},
    {"rho_p", "first state from which on a realisation percolates, mean over the realisations", "S2 Sec. 4", true},
    // of the histograms of all realisations added up, at the last state; errors by jackknife (peaks of G: bootstrap),
    // with
    // one realisation those of the fit or of the bootstrap over its grains
    {"tail_k_pooled", "exponent k of P(f) ~ exp(-k f) for f > 1, least squares with a free prefactor", "S3 Eq. 2"},
    {"tail_k_loglinear_pooled", "the same from a line through ln P", "theory sec. 4"},
    {"peak_position_pooled", "centre of the highest bin of P(f) beyond f = .3", "S3 Fig. 5"},
    {"peak_prominence_pooled", "P there less P of the lowest bin before it; counting error", "S3 Fig. 5"},
    {"type_a_pooled", "1 where that peak stands out by more than two errors (type A), 0 where P(f) is of type B",
     "S3 Fig. 1"},
    {"bend_pooled",
     "c of ln P = a + b f + c f^2 on .2 < f < 2: below 0 where P(f) has a peak or a shoulder, 0 for an exponential; "
     "counting error",
     "theory sec. 4"},
    {"mueth_a_pooled", "a of Mueth's law a (1 - b exp(-f^2)) exp(-beta f) fitted to P(f)", "S3 Eq. 1"},
    {"mueth_b_pooled", "b of Mueth's law", "S3 Eq. 1"},
    {"mueth_beta_pooled", "beta of Mueth's law", "S3 Eq. 1"},
    {"force_contacts_pooled", "contacts behind P(f)", "S3 Data analysis"},
    {"rdf_peak1_pooled", "position of the first peak of G(r), in L", "S3 Table 2"},
    {"rdf_peak2_pooled", "position of the second peak of G(r), in L", "S3 Table 2"},
    {"rdf_peak3_pooled", "position of the third peak of G(r), in L", "S3 Table 2"},
};

}  // namespace

std::span<const TransitionKind> transition_kinds() { return kinds; }

}  // namespace jam
