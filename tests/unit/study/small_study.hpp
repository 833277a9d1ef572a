// A study for tests, and what is wrong with one.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

inline constexpr std::string_view small_study = R"([study]
name = "small"
seed = 5
realisations = 3

[grains]
count = 100
width = 0.2

[[stage]]
name = "compress"
to = 0.8
speed = 1e-3
frames = 5

[[system]]
name = "smooth"
contact.friction = 0

[[system]]
name = "rough"
contact.friction = 0.5
stage.compress.speed = 2e-3
)";

/// "place | problem | suggestion" of the usage error that reading `text` gives.
inline std::string complaint_about(const std::string& text, const std::string& file,
                                   const std::vector<Setting>& settings = {}) {
  try {
    read_study_text(text, file, settings);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::usage);
    return e.place() + " | " + e.problem() + " | " + e.suggestion();
  }
  ADD_FAILURE() << "nothing was wrong with\n" << text;
  return {};
}

}  // namespace jam
