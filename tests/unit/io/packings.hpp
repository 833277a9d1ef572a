// Packings with random content, folders that vanish, and bitwise comparison, for the tests of this folder.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "jamscape/packing/difference.hpp"

namespace jam::testing {

/// A folder of its own for one test.
class Folder {
 public:
  Folder() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() / (std::string("jamscape-") + info->test_suite_name() + "-" +
                                                      info->name() + "-" + std::to_string(::getpid()));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
inline void put_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// While it lives no file may grow beyond `bytes`: a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

struct Recipe {
  int dimension = 2;
  std::size_t grains = 50, contacts = 90, bead_walls = 4, plane_walls = 0;
  unsigned seed = 1;
  std::size_t shapes = 0;  ///< above 0: clusters, and a cylinder as the last wall
};

/// Clusters of `count` shapes: as arbitrary as the rest, but that arms have sizes and directions.
inline void make_clusters(Packing& p, std::size_t count, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  const bool flat = p.dimension == 2;
  const auto unit = [&] {
    const Vec3 v{normal(generator), normal(generator), flat ? 0.0 : normal(generator)};
    return (1 / norm(v)) * v;
  };
  const auto size = [&] { return std::abs(normal(generator)) + 1e-300; };
  for (std::size_t s = 0; s < count; ++s) {
    ClusterShape shape{"Form " + std::to_string(s), {},     size(), size(), size(),
                       {size(), size(), size()},    size(), size()};
    for (std::size_t a = 0; a < 1 + s; ++a)
      shape.arms.push_back(
          {{normal(generator), -0.0, flat ? 0 : normal(generator)}, unit(), s == 0 ? 0 : size(), size()});
    p.shapes.push_back(shape);
  }
  Grains& g = p.grains;
  for (std::size_t n = 0; n < g.size(); ++n) {
    g.shape.push_back(static_cast<std::int32_t>(generator() % count));
    g.scale.push_back(size());
    const double w = normal(generator), z = normal(generator);
    const Quaternion out_of_plane{w, normal(generator), normal(generator), z};
    g.orientation.push_back(normalized(flat ? Quaternion{w, 0, 0, z} : out_of_plane));
  }
  const auto arms = [&](std::size_t n) { return p.shapes[static_cast<std::size_t>(g.shape[n])].arms.size(); };
  Contacts& c = p.contacts;
  for (std::size_t m = 0; m < c.size(); ++m) {
    const std::size_t ends = c.j[m] < 0 ? 2 : arms(static_cast<std::size_t>(c.j[m]));
    c.part_i[m] = static_cast<std::uint16_t>(c.part_i[m] % arms(c.i[m]));
    c.part_j[m] = static_cast<std::uint16_t>(c.part_j[m] % ends);
  }
  if (p.walls.empty()) return;
  p.walls.back().kind = WallKind::cylinder;
  p.walls.back().radius = size();
}

/// Nothing in it makes physical sense, but every member is set and every index is valid.
inline Packing random_packing(const Recipe& recipe) {
  std::mt19937_64 generator(recipe.seed);
  std::normal_distribution<double> normal;
  const auto number = [&] { return normal(generator) * std::pow(10.0, 40 * normal(generator)); };
  const auto below = [&](std::size_t n) { return generator() % n; };
  const bool flat = recipe.dimension == 2;
  const auto vec = [&] { return Vec3{number(), number(), flat ? 0.0 : number()}; };
  const auto rotation = [&] { return flat ? Vec3{0, 0, number()} : Vec3{number(), number(), number()}; };

  Packing p;
  p.dimension = recipe.dimension;
  p.step = static_cast<std::int64_t>(generator() >> 2);
  p.time = number();
  p.stage = "Stufe " + std::to_string(below(9)) + " ρ→0.9";
  p.packing_fraction = number();
  p.packing_fraction_plain = number();
  p.domain.lo = {number(), number(), number()};
  p.domain.hi = {number(), number(), number()};
  p.domain.periodic = {below(2) == 1, below(2) == 1, below(2) == 1};
  for (std::size_t n = 0; n < recipe.grains; ++n) {
    p.grains.id.push_back(static_cast<std::int64_t>(generator()));
    p.grains.species.push_back(static_cast<std::int32_t>(below(3)));
    p.grains.radius.push_back(number());
    p.grains.mass.push_back(number());
    p.grains.position.push_back(vec());
    p.grains.velocity.push_back(vec());
    p.grains.spin.push_back(rotation());
    p.grains.angle.push_back(rotation());
  }
  const std::size_t walls = recipe.bead_walls + recipe.plane_walls;
  for (std::size_t m = 0; m < recipe.contacts; ++m) {
    Contacts& c = p.contacts;
    c.i.push_back(static_cast<std::uint32_t>(below(recipe.grains)));
    c.j.push_back(static_cast<std::int32_t>(below(recipe.grains + walls)) - static_cast<std::int32_t>(walls));
    c.part_i.push_back(static_cast<std::uint16_t>(generator()));
    c.part_j.push_back(static_cast<std::uint16_t>(generator()));
    c.image.push_back({static_cast<std::int8_t>(below(3) - 1), static_cast<std::int8_t>(below(3) - 1),
                       static_cast<std::int8_t>(flat ? 0 : below(3) - 1)});
    c.overlap.push_back(number());
    c.normal_force.push_back(number());
    c.normal.push_back(vec());
    c.tangential_force.push_back(vec());
    c.point.push_back(vec());
    c.sliding.push_back(static_cast<std::uint8_t>(below(2)));
  }
  for (std::size_t w = 0; w < walls; ++w) {
    const bool beads = w < recipe.bead_walls;
    Wall wall{beads ? WallKind::beads : WallKind::plane, vec(), vec(), vec(), vec(), beads ? number() : 0, {}, 0};
    for (std::size_t b = 0; beads && b < 5 + w; ++b) wall.beads.push_back(vec());
    wall.role = static_cast<WallRole>(below(3));
    p.walls.push_back(wall);
  }
  p.energy = {number(), number(), number(), number(), number(), number()};
  if (recipe.shapes > 0) make_clusters(p, recipe.shapes, generator);
  return p;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

inline void expect_same(const Packing& a, const Packing& b) { EXPECT_EQ(first_difference(a, b), ""); }

/// The message of the jam::Error that `call` throws; fails the test when it throws none.
template <class Call>
std::string error_of(Call call);

}  // namespace jam::testing

#include "jamscape/base/error.hpp"

template <class Call>
std::string jam::testing::error_of(Call call) {
  try {
    call();
  } catch (const jam::Error& error) {
    EXPECT_EQ(error.code(), jam::ExitCode::data);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}
