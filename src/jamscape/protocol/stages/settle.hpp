// settle: grains fall and come to rest on the floor of a container; one frame at the end.
#pragma once

#include <utility>

#include "jamscape/protocol/stages/stage.hpp"

namespace jam {

/// When grains that fall have settled: after a time given by the height h they start from, or when they rest.
enum class SettleUntil { time, rest };
template <>
struct EnumNames<SettleUntil> {
  static constexpr std::pair<SettleUntil, std::string_view> values[] = {{SettleUntil::time, "time"},
                                                                        {SettleUntil::rest, "rest"}};
};

struct Settle {
  static constexpr StageTraits traits = {.text = "lets the grains fall"};

  struct Options {
    SettleUntil settle_until = SettleUntil::time;
    double settle_times = 3;

    template <class V>
    void describe(V& v) {
      v.option("settle_until", settle_until,
               {.text = "settle: ends after settle_times sqrt(2 h/g), h being the height of the start, or when the "
                        "grains rest (relax_energy; after that time at the latest)",
                .source = "S3 Methods"});
      v.option("settle_times", settle_times,
               {.text = "settle: longest duration over the time sqrt(2 h/g) of the deepest fall",
                .min = 0.1,
                .max = 1000,
                .source = "S3 Methods"});
    }
  };

  static void write(const StageOptions& stage, ContainerTimetable& table);
};

}  // namespace jam
