// A study: systems times realisations, and what is measured and shown of them. Read from study.toml:
//
//   [study]   name, title, seed, realisations, targets
//   [grains] [domain] [contact] [integrator] [start]      options of all systems (protocol/options.hpp)
//   [units]                                               what d, m and tau_c are in SI (unit_options.hpp)
//   [[stage]]                                             the protocol, stage after stage
//   [[system]] name = "...", grains.width = 0.2, stage.NAME.speed = 1e-4, ...
//   [sweep]   grains.width = [0.1, 0.2]                   every system (or the bare study) times every combination
//   [measure] list = [...], and options of the measures   (observe/options.hpp)
//   [report]  options of the report
//
// A study without [[system]] is one system of the study's own name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jamscape/base/schema.hpp"
#include "jamscape/observe/options.hpp"
#include "jamscape/protocol/options.hpp"
#include "jamscape/study/unit_options.hpp"

namespace jam {

/// What becomes of simulations that make or lose energy.
enum class LedgerRule { closed, open };
template <>
struct EnumNames<LedgerRule> {
  static constexpr std::pair<LedgerRule, std::string_view> values[] = {{LedgerRule::closed, "closed"},
                                                                       {LedgerRule::open, "open"}};
};

struct StudyInfo {
  std::string name;
  std::string title;
  std::int64_t seed = 1;
  std::int64_t realisations = 1;
  std::string targets;
  LedgerRule ledger = LedgerRule::closed;
  double ledger_mark = 0.01;
  double ledger_stop = 0.1;

  template <class V>
  void describe(V& v) {
    v.option("name", name, {.text = "name of the study, and of its folder of results"});
    v.option("title", title, {.text = "one line for people, shown on top of the report"});
    v.option("seed", seed, {.text = "seed of all random numbers", .min = 0, .max = 9e18});
    v.option("realisations", realisations,
             {.text = "number of realisations of each system; more may be asked for later", .min = 1, .max = 1e6});
    v.option("targets", targets, {.text = "name of the published values that `jamscape score` compares with"});
    v.option("ledger", ledger,
             {.text = "closed: a run whose energy ledger is off by more than ledger_stop ends as failed, and marked "
                      "frames enter no mean; open: runs go on, and means take marked frames in, with their number "
                      "beside them (`marked`)",
              .source = "theory 2.5"});
    v.option(
        "ledger_mark", ledger_mark,
        {.text =
             "a frame is marked where |ledger_sum - E| is above this part of what was turned over, E + |wall_work| + "
             "|gravity_work| + |damped| + |rubbed|; E is the kinetic energy of the start",
         .min = 0,
         .max = 1e6,
         .source = "theory 2.5"});
    v.option("ledger_stop", ledger_stop,
             {.text = "closed: the part of what was turned over at which a run ends as failed",
              .min = 0,
              .max = 1e6,
              .source = "theory 2.5"});
  }
};

struct ReportOptions {
  std::vector<double> pictures;

  template <class V>
  void describe(V& v) {
    v.option(
        "pictures", pictures,
        {.text =
             "packing fractions whose force networks are pictured (the nearest frames); empty: a few, evenly spaced",
         .min = 0,
         .max = 2});
  }
};

struct MeasureChoice {
  std::vector<std::string> list;

  template <class V>
  void describe(V& v) {
    v.option("list", list,
             {.text = "measures to take, those of several rows at every frame unless rows_every is given; empty: all"});
  }
};

struct System {
  std::string name;
  SystemOptions options;
  UnitOptions units;
  Scales scales;                              ///< what follows from them; 0 in a study without units
  std::map<std::string, std::string> places;  ///< where each key was written, as file:line:column
};

struct Study {
  StudyInfo info;
  SystemOptions base;           ///< what the systems share, as written
  UnitOptions units;            ///< likewise
  std::vector<System> systems;  ///< resolved: overrides and sweep applied
  MeasureChoice measures;
  MeasureOptions measure;
  ReportOptions report;
  std::string file;  ///< where it was read from, for messages
};

/// A change from the command line: --set contact.friction=0.3
struct Setting {
  std::string key, value;
};

/// Throws a usage error unless `text` reads key=value.
Setting read_setting(std::string_view text);

/// Reads a study; throws a usage error with file:line:column for everything that is wrong in it.
Study read_study(const std::filesystem::path& file, const std::vector<Setting>& settings = {});
Study read_study_text(std::string_view text, const std::string& file_name, const std::vector<Setting>& settings = {});

/// The study with every default written out; read_study_text() of it gives the same study.
std::string print_study(const Study& study);

/// All options of a system, those of its stages as "stage.NAME.key".
std::vector<Option> system_options(SystemOptions& system);

/// One line of `key = value` for each option of `system` that differs from `other`, in the order of the options.
std::vector<std::string> differing_options(const SystemOptions& system, const SystemOptions& other);

/// Keys of the options that are not the same in all systems, in the order of the options: the columns of the tables.
std::vector<std::string> varied_options(const Study& study);

/// Every option a study file may have, bound to a throw-away default; for explain and the reference.
struct KnownOption {
  std::string key, type, range, default_value;
  OptionMeta meta;
};
std::vector<KnownOption> known_options();

}  // namespace jam
