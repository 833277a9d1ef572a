#include "jamscape/observe/options.hpp"

#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

std::string place_of_complaint(const MeasureOptions& options) {
  try {
    check(options);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::usage);
    EXPECT_FALSE(e.suggestion().empty());
    return e.place();
  }
  return "";
}

TEST(MeasureOptions, AreCheckedTogether) {
  EXPECT_EQ(place_of_complaint({}), "");
  MeasureOptions o;
  o.force_min = 0;
  EXPECT_EQ(place_of_complaint(o), "measure.force_min");
  o.force_scale = ForceScale::linear;
  EXPECT_EQ(place_of_complaint(o), "");
  o.force_max = 0;
  EXPECT_EQ(place_of_complaint(o), "measure.force_max");
  o = {};
  o.level_max = 1e6;
  EXPECT_EQ(place_of_complaint(o), "measure.level_max");
  o = {};
  o.betti_max = 1e6;
  o.betti_step = 0.5;
  EXPECT_EQ(place_of_complaint(o), "measure.betti_max");
  o = {};
  o.rdf_range = 1000;
  o.rdf_bin = 1e-4;
  EXPECT_EQ(place_of_complaint(o), "measure.rdf_range");
}

}  // namespace
}  // namespace jam
