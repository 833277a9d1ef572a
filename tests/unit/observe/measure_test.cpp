#include "jamscape/observe/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "jamscape/base/error.hpp"
#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/explain.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

void check_columns(const Measure& m, const Table& t) {
  ASSERT_EQ(t.columns.size(), m.columns.size()) << m.name;
  for (std::size_t k = 0; k < m.columns.size(); ++k) {
    EXPECT_EQ(t.columns[k].name, m.columns[k].name) << m.name;
    EXPECT_EQ(t.columns[k].size(), t.rows()) << m.name;
  }
}

/// Where no grain has two contacts, a lid carries nothing, or there is nothing to fit.
bool may_be_missing(const Measure& m, const ColumnInfo& c) {
  return c.name == "percolation_estimate" || c.name == "weight_over_load" || c.name == "unbalanced_force" ||
         m.name == "force_tail" || m.name == "rdf_peaks";
}

class EveryMeasure : public testing::TestWithParam<int> {};

TEST_P(EveryMeasure, GivesTheColumnsItDeclares) {
  for (Packing p : {cloud(GetParam(), 120, 3), ideal_gas(GetParam(), {9, 9, GetParam() == 3 ? 9.0 : 0}, 10, true),
                    box(GetParam(), {4, 4, GetParam() == 3 ? 4.0 : 0})}) {
    p.packing_fraction = 0.8;
    const Snapshot s(p, {});
    for (const Measure& m : measures()) {
      const Table t = m.evaluate(s);
      check_columns(m, t);
      if (m.rows == Rows::many) continue;
      EXPECT_EQ(t.rows(), 1u) << m.name;
      for (const ColumnInfo& c : m.columns) {
        if (may_be_missing(m, c)) continue;
        EXPECT_TRUE(std::isfinite(t.numbers(c.name)[0])) << c.name;
      }
    }
  }
}

TEST_P(EveryMeasure, WithSeveralRowsIsLeftOutBetweenItsPackingFractions) {
  Packing p = cloud(GetParam(), 60, 3);
  p.packing_fraction = 0.807;
  const Snapshot s(p, {});
  MeasureOptions every;
  every.rows_every = 0;
  const Snapshot all(p, every);
  for (const Measure& m : measures()) {
    const Table t = m.evaluate(s);
    check_columns(m, t);
    EXPECT_EQ(t.rows(), m.rows == Rows::frame ? 1u : 0u) << m.name;
    EXPECT_GT(m.evaluate(all).rows(), 0u) << m.name;
  }
}

TEST(SeveralRows, OfClustersAreTakenAtAnyPackingFraction) {
  Packing p = box(2, {20, 20, 0});
  p.packing_fraction = 0.807;
  p.shapes = {cross_shape(3)};
  add_body(p, {5, 5, 0});
  const Snapshot s(p, {});
  for (const char* name : {"particle_stress", "stress_distribution", "level_sets"})
    EXPECT_GT(find_measure(name).evaluate(s).rows(), 0u) << name;
}

INSTANTIATE_TEST_SUITE_P(Dimensions, EveryMeasure, testing::Values(2, 3));

TEST(Registry, NamesEachMeasureAndEachColumnOfTheFrameTableOnce) {
  std::set<std::string> names, columns;
  for (const Measure& m : measures()) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_FALSE(m.title.empty() || m.formula.empty() || m.source.empty()) << m.name;
    EXPECT_LE(m.abscissae, static_cast<int>(m.columns.size()));
    for (const ColumnInfo& c : m.columns) {
      EXPECT_FALSE(c.text.empty()) << c.name;
      if (m.rows == Rows::many) continue;
      EXPECT_TRUE(columns.insert(c.name).second) << c.name;
    }
  }
}

TEST(Registry, HasTheColumnsThatTablesAndReportsRelyOn) {
  std::set<std::string> columns;
  for (const Measure& m : measures())
    if (m.rows == Rows::frame)
      for (const ColumnInfo& c : m.columns) columns.insert(c.name);
  for (const char* name : {"contacts",
                           "wall_contacts",
                           "mean_normal_force",
                           "z",
                           "z_walls",
                           "z_multi",
                           "rattlers",
                           "psi6",
                           "psi6_closed",
                           "psi6_local",
                           "psi6_global",
                           "b0_rough",
                           "b0_strong",
                           "b0_medium",
                           "b0_weak",
                           "b1_rough",
                           "b1_strong",
                           "b1_medium",
                           "b1_weak",
                           "tp0",
                           "tp1",
                           "tp2",
                           "z_backbone",
                           "grains_backbone",
                           "percolates_x",
                           "percolates_y",
                           "percolates_z",
                           "percolates",
                           "percolating_fraction",
                           "percolation_estimate",
                           "mean_degree",
                           "stress_xx",
                           "stress_yy",
                           "stress_xy",
                           "pressure",
                           "wall_force_x_lo",
                           "wall_force_x_hi",
                           "wall_force_y_lo",
                           "wall_force_y_hi",
                           "wall_pressure",
                           "unbalanced_force",
                           "kinetic",
                           "elastic",
                           "damped",
                           "rubbed",
                           "wall_work",
                           "gravity_work",
                           "ledger_sum",
                           "box_lx",
                           "box_ly",
                           "solid_fraction",
                           "area_fraction",
                           "height",
                           "weight_over_load",
                           "deepest_overlap",
                           "force_contacts",
                           "mean_contact_force",
                           "fraction_above_max",
                           "fraction_above_8",
                           "largest_force",
                           "tail_k",
                           "tail_k_error",
                           "tail_k_loglinear",
                           "tail_k_mle",
                           "mueth_beta",
                           "gauss_centre",
                           "gauss_width",
                           "peak_position",
                           "peak_prominence",
                           "type_a",
                           "bend",
                           "bend_error",
                           "rdf_peak1",
                           "rdf_peak1_error",
                           "rdf_peak3",
                           "rdf_d1",
                           "rdf_j1"})
    EXPECT_EQ(columns.count(name), 1u) << name;
  for (const char* name :
       {"betti", "level_sets", "pair_correlation", "force_distribution", "diagram", "contact_force_distribution",
        "stress_distribution", "radial_distribution", "particle_stress"})
    EXPECT_EQ(find_measure(name).rows, Rows::many) << name;
  EXPECT_FALSE(find_measure("diagram").averaged);
  EXPECT_FALSE(find_measure("particle_stress").averaged);
}

TEST(Registry, SaysHowTheEnsembleAverages) {
  const Measure& m = find_measure("level_sets");
  std::map<std::string, Averaging> by_column;
  for (const ColumnInfo& c : m.columns) by_column[c.name] = c.averaging;
  for (const char* name : {"threshold", "b0", "b1", "b2", "clusters", "cluster_grains", "mean_cluster", "percolating_x",
                           "percolating_y", "percolating_z"})
    EXPECT_EQ(by_column.at(name), Averaging::mean) << name;
  EXPECT_EQ(by_column.at("percolating_grains"), Averaging::nonzero_or_missing);
  EXPECT_EQ(by_column.at("shape"), Averaging::nonzero_or_zero);
  for (const Measure& each : measures())
    for (const PooledRatio& r : each.ratios)
      for (const std::string& name : {r.over, r.under})
        EXPECT_TRUE(
            std::any_of(each.columns.begin(), each.columns.end(), [&](const auto& c) { return c.name == name; }))
            << r.name << " needs " << name;
  ASSERT_EQ(m.ratios.size(), 1u);
  EXPECT_EQ(m.ratios[0].name, "mean_cluster_pooled");
}

TEST(Registry, OffersTheNearestName) {
  try {
    find_measure("coordinaton");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::usage);
    EXPECT_NE(e.suggestion().find("'coordination'"), std::string::npos) << e.suggestion();
    EXPECT_NE(e.suggestion().find("pair_correlation"), std::string::npos);
  }
}

TEST(Registry, KnowsMultiplesOfTheInterval) {
  EXPECT_TRUE(is_multiple(0.82, 0.02));
  EXPECT_TRUE(is_multiple(0.8200004, 0.02));
  EXPECT_TRUE(is_multiple(0.81999999, 0.02));
  EXPECT_FALSE(is_multiple(0.823, 0.02));
  EXPECT_FALSE(is_multiple(0.83, 0.02));
  EXPECT_TRUE(is_multiple(0.8234, 0));
  EXPECT_TRUE(is_multiple(0, 0.02));
}

TEST(Explain, SaysEverythingAboutAMeasure) {
  for (const Measure& m : measures()) {
    const std::string text = explain(m), page = measures_reference();
    for (const std::string& part : {m.name, m.title, m.formula, m.source})
      EXPECT_NE(text.find(part), std::string::npos) << part;
    for (const ColumnInfo& c : m.columns) {
      EXPECT_NE(text.find(c.name + " "), std::string::npos) << c.name;
      EXPECT_NE(page.find("| `" + c.name + "` |"), std::string::npos) << c.name;
    }
  }
}

TEST(Explain, FindsAMeasureByItsColumns) {
  EXPECT_EQ(explain_measure("z_multi"), explain(find_measure("coordination")));
  EXPECT_EQ(explain_measure("betti"), explain(find_measure("betti")));
  EXPECT_EQ(explain_measure("mean_cluster_pooled"), explain(find_measure("level_sets")));
  EXPECT_NE(explain_measure("shape").find("0 if at least half are 0"), std::string::npos);
  EXPECT_THROW(explain_measure("zz_multi_x"), Error);
}

TEST(Explain, KeepsTheBordersOfMarkdownTables) {
  const std::string page = measures_reference();
  std::size_t begin = 0;
  while (begin < page.size()) {
    const std::size_t end = page.find('\n', begin);
    const std::string line = page.substr(begin, end - begin);
    begin = end + 1;
    if (line.rfind("| ", 0) != 0) continue;
    int borders = 0;
    for (std::size_t k = 0; k < line.size(); ++k) borders += line[k] == '|' && (k == 0 || line[k - 1] != '\\');
    EXPECT_EQ(borders, 4) << line;
  }
}

}  // namespace
}  // namespace jam
