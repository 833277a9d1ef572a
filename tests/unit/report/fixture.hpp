// A folder of made-up results (tests/web/fixture.hpp), written once for all tests of a suite.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "../../web/fixture.hpp"

namespace jam::testing {

template <class Writer>
class StoredResults : public ::testing::Test {
 protected:
  static std::filesystem::path folder() {
    return std::filesystem::temp_directory_path() / (std::string(Writer::name) + std::to_string(::getpid()));
  }
  static void SetUpTestSuite() {
    std::filesystem::remove_all(folder());
    std::filesystem::create_directories(folder());
    Writer::write(folder());
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }
};

}  // namespace jam::testing
