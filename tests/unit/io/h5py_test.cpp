// A run.h5 read by an independent program: h5py.
#include <sys/wait.h>

#include <cstdlib>

#include "jamscape/io/packing_csv.hpp"
#include "jamscape/io/run_file.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace testing;

/// The exit status of check_run.py under the first Python that has h5py; 77 when none has.
int check_run(const std::string& arguments) {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    const int status = std::system((std::string(python) + " " CHECK_RUN " " + arguments).c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) != 77 && WEXITSTATUS(status) != 127) return WEXITSTATUS(status);
  }
  return 77;
}

TEST(RunFile, OpensInH5pyWithTheLayoutWeDescribe) {
  for (int dimension : {2, 3}) {
    const Folder folder;
    std::vector<std::filesystem::path> frames;
    std::string arguments = (folder / "run.h5").string();
    Packing first;
    for (unsigned k = 0; k < 3; ++k) {
      Packing p = random_packing({.dimension = dimension,
                                  .grains = 600,
                                  .contacts = 900 + k,
                                  .seed = 30 + k,
                                  .shapes = dimension == 3 ? 2u : 0u});
      for (std::size_t n = 0; n < p.grains.size(); ++n) p.grains.id[n] = static_cast<std::int64_t>(3 * n + 1);
      if (k == 0) first = p;
      p.shapes = first.shapes;
      p.grains.radius = first.grains.radius;
      p.grains.mass = first.grains.mass;
      p.grains.species = first.grains.species;
      const std::string number = std::to_string(k);
      frames.push_back(folder / (number + ".h5"));
      write_frame(frames.back(), p);
      write_packing_csv(p, folder / ("p" + number + ".csv"), folder / ("c" + number + ".csv"));
      for (const char* table : {"p", "c"}) arguments.append(" ").append((folder / (table + number + ".csv")).string());
    }
    assemble_run(frames, folder / "run.h5", {"count = 50  # Körner\n", "0.1.0", {{"seed", "42"}}});
    const int status = check_run(arguments);
    if (status == 77) GTEST_SKIP() << "no python3 with h5py: install python3-h5py to check run.h5 with it";
    EXPECT_EQ(status, 0);
  }
}

}  // namespace
}  // namespace jam
