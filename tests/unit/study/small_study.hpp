// A study for tests.
#pragma once

#include <string_view>

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

}  // namespace jam
