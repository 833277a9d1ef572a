// What both engines say of a simulation that is no longer sound.
#include "jamscape/dem/diverged.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "jamscape/dem/cluster_kernel.hpp"
#include "jamscape/dem/kernel.hpp"
#include "jamscape/dem/kernel_choice.hpp"

namespace jam {
namespace {

TEST(Diverged, names_step_body_place_and_cause) {
  const std::vector<double> place = {1.5, -2};
  const std::string what = diverged_at(7, "grain 3", place, "is lost", "the step is too long").what();
  EXPECT_EQ(what, "step 7: grain 3 at (1.500000, -2.000000) is lost; likely the step is too long");
}

TEST(Diverged, names_a_wall_by_its_side_and_place) {
  EXPECT_EQ(beyond_plane(0.25, true, 1, 3), "0.25 beyond the upper wall at y = 3");
  EXPECT_EQ(beyond_plane(1, false, 2, -0.5), "1 beyond the lower wall at z = -0.5");
}

TEST(Diverged, finds_the_first_row_that_is_not_finite) {
  std::vector<double> rows(12, 1.0);
  EXPECT_EQ(find_not_finite(rows.data(), 3, 4), 3u);
  rows[11] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(find_not_finite(rows.data(), 3, 4), 2u);
  rows[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(find_not_finite(rows.data(), 3, 4), 1u);
}

TEST(Diverged, a_step_is_too_long_where_a_contact_lasts_less_than_eight) {
  // two bodies of mass 2, k_n = pi^2: mbar = 1, the contact lasts 1
  const double k_n = 9.869604401089358;
  EXPECT_EQ(step_too_long(0.124, 2, k_n, "grains"), "");
  EXPECT_EQ(
      step_too_long(0.126, 2, k_n, "grains"),
      "the time step 0.126 is too long for the stiffness: a contact of the lightest grains lasts 1; 0.025 would do");
}

TEST(KernelChoice, both_engines_use_kernels_of_one_width) {
  ASSERT_EQ(available_kernels().size(), widths_available());
  ASSERT_EQ(available_cluster_kernels().size(), widths_available());
  for (std::size_t k = 0; k < widths_available(); ++k) {
    EXPECT_STREQ(available_kernels()[k]->name, width_names[k]);
    EXPECT_STREQ(available_cluster_kernels()[k]->name, width_names[k]);
  }
  EXPECT_STREQ(best_kernels().name, best_cluster_kernels().name);
  EXPECT_STREQ(best_kernels().name, width_names[width_in_use()]);
}

}  // namespace
}  // namespace jam
