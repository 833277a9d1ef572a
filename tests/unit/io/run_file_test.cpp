#include "jamscape/io/run_file.hpp"

#include <thread>

#include "jamscape/io/seal.hpp"
#include "packings.hpp"
#include "plain_packing.hpp"

namespace jam {
namespace {

using namespace testing;
using Paths = std::vector<std::filesystem::path>;

const Recipe recipes[] = {
    {.dimension = 2},
    {.dimension = 2, .bead_walls = 0, .plane_walls = 4, .seed = 2},
    {.dimension = 2, .bead_walls = 0, .plane_walls = 0, .seed = 3},
    {.dimension = 2, .contacts = 0, .seed = 4},
    {.dimension = 2, .grains = 2000, .contacts = 4000, .seed = 5},
    {.dimension = 3, .seed = 6},
    {.dimension = 3, .grains = 1, .contacts = 3, .bead_walls = 1, .plane_walls = 6, .seed = 7},
    {.dimension = 3, .grains = 0, .contacts = 0, .bead_walls = 0, .seed = 8},
    {.dimension = 2, .bead_walls = 0, .plane_walls = 4, .seed = 9, .shapes = 3},
    {.dimension = 3, .bead_walls = 0, .plane_walls = 3, .seed = 10, .shapes = 1},
    {.dimension = 3, .grains = 0, .contacts = 0, .bead_walls = 0, .seed = 11, .shapes = 2},
};

/// Frames of one run: the lasting properties of the grains stay, all else differs.
std::vector<Packing> run_of(std::size_t frames, int dimension) {
  std::vector<Packing> run;
  for (std::size_t k = 0; k < frames; ++k) {
    run.push_back(
        random_packing({.dimension = dimension, .contacts = 60 + 7 * k, .seed = static_cast<unsigned>(k + 20)}));
    const Grains& first = run.front().grains;
    Grains& g = run.back().grains;
    g.id = first.id;
    g.species = first.species;
    g.radius = first.radius;
    g.mass = first.mass;
  }
  return run;
}

Paths store(const Folder& folder, const std::vector<Packing>& run) {
  Paths paths;
  for (std::size_t k = 0; k < run.size(); ++k) {
    paths.push_back(folder / (std::to_string(k) + ".h5"));
    write_frame(paths.back(), run[k]);
  }
  return paths;
}

const Provenance provenance{"[grains]\ncount = 50 # Körner\n", "0.1.0", {{"seed", "42"}, {"git", "abc"}}};

void expect_run(const std::filesystem::path& path, const std::vector<Packing>& run) {
  const RunFile file(path);
  ASSERT_EQ(file.frames(), run.size());
  for (std::size_t k : {run.size() - 1, std::size_t{0}, run.size() / 2}) expect_same(file.frame(k), run[k]);
  for (std::size_t k = 0; k < run.size(); ++k) {
    expect_same(file.frame(k), run[k]);
    EXPECT_EQ(file.steps()[k], run[k].step);
    EXPECT_EQ(file.times()[k], run[k].time);
    EXPECT_EQ(file.stages()[k], run[k].stage);
    EXPECT_EQ(file.packing_fractions()[k], run[k].packing_fraction);
  }
}

TEST(FrameFile, KeepsEveryBit) {
  const Folder folder;
  for (const Recipe& recipe : recipes) {
    const Packing p = random_packing(recipe);
    write_frame(folder / "frame.h5", p);
    expect_same(read_frame(folder / "frame.h5"), p);
  }
  EXPECT_EQ(folder.files(), 1u);
}

TEST(FrameFile, EqualContentGivesEqualBytes) {
  const Folder folder;
  write_frame(folder / "a.h5", random_packing({}));
  write_frame(folder / "b.h5", random_packing({}));
  EXPECT_EQ(bytes_of(folder / "a.h5"), bytes_of(folder / "b.h5"));
}

TEST(FrameFile, RefusesWhatItCannotKeep) {
  const Folder folder;
  Packing p = random_packing({});
  p.contacts.normal[3][2] = 1e-300;
  EXPECT_NE(error_of([&] { write_frame(folder / "frame.h5", p); }).find("contact normal of entry 3"),
            std::string::npos);
  p.dimension = 4;
  error_of([&] { write_frame(folder / "frame.h5", p); });
  EXPECT_EQ(folder.files(), 0u);
}

TEST(FrameFile, RefusesClustersThatMakeNoSense) {
  const Folder folder;
  const Packing sound = random_packing({.bead_walls = 0, .plane_walls = 1, .shapes = 3});
  const auto refused = [&](auto spoil) {
    Packing p = sound;
    spoil(p);
    const std::string message = error_of([&] { write_frame(folder / "frame.h5", p); });
    EXPECT_EQ(folder.files(), 0u);
    return message;
  };
  const auto says = [](const std::string& message, const char* text) {
    EXPECT_NE(message.find(text), std::string::npos) << message;
  };
  says(refused([](Packing& p) { p.grains.shape[4] = 3; }), "grain 4 is of shape 3, but there are 3");
  says(refused([](Packing& p) { p.grains.shape[4] = -1; }), "grain 4 is of shape -1");
  says(refused([](Packing& p) { p.grains.scale[7] = 0; }), "grain 7 has size factor 0");
  says(refused([](Packing& p) { p.grains.orientation[5].w += 1e-5; }), "no unit quaternion");
  says(refused([](Packing& p) { p.grains.orientation[5] = {0, 1, 0, 0}; }), "grain 5 is turned out of the plane");
  says(refused([](Packing& p) { p.grains.orientation.pop_back(); }), "50 size factors and 49 orientations");
  says(refused([](Packing& p) { p.shapes.clear(); }), "50 shapes");
  says(refused([](Packing& p) { p.shapes[2].arms[1].half_length = NAN; }), "shape 2 has an arm 1 that is not finite");
  says(refused([](Packing& p) { p.shapes[2].arms[1].radius = 0; }), "has no size");
  says(refused([](Packing& p) { p.shapes[2].arms[1].direction = {0.5, 0, 0}; }), "no unit vector");
  says(refused([](Packing& p) { p.shapes[2].arms[1].centre[2] = 1; }), "leaves the plane");
  says(refused([](Packing& p) { p.shapes[1].arms.clear(); }), "shape 1 has no arms");
  says(refused([](Packing& p) { p.shapes[1].volume = INFINITY; }), "volume that is not finite");
  says(refused([](Packing& p) { p.contacts.part_i[6] = 3; }), "contact 6 joins parts 3 and");
  says(refused([](Packing& p) { p.walls[0].radius = 0; }), "a cylinder has the radius 0");
}

/// A frame file whose content was changed by other hands and sealed again.
TEST(FrameFile, ClustersOfOtherHandsAreChecked) {
  const Folder folder;
  const Packing p = random_packing({.dimension = 3, .grains = 3, .contacts = 2, .shapes = 2});
  write_frame(folder / "frame.h5", p);
  const std::string sound = unseal(bytes_of(folder / "frame.h5"), "frame.h5");
  const auto changed = [&](const auto& from, const auto& to) {
    std::string bytes = sound;
    const std::string old(reinterpret_cast<const char*>(&from), sizeof from);
    const auto at = bytes.find(old);
    EXPECT_NE(at, std::string::npos);
    std::memcpy(bytes.data() + at, &to, sizeof to);
    put_bytes(folder / "frame.h5", seal(std::move(bytes)));
    return error_of([&] { read_frame(folder / "frame.h5"); });
  };
  const Quaternion twice{2 * p.grains.orientation[1].w, 0, 0, 0};
  EXPECT_NE(changed(p.grains.orientation[1], twice).find("in frame 0, grain 1 has an orientation"), std::string::npos);
  EXPECT_NE(changed(p.grains.scale[2], -1.0).find("grain 2 has size factor -1"), std::string::npos);
  EXPECT_NE(changed(p.shapes[1].arms[1].half_length, double{NAN}).find("shape 1 has an arm 1 that is not finite"),
            std::string::npos);
  const std::array<std::int32_t, 3> shapes{p.grains.shape[0], p.grains.shape[1], p.grains.shape[2]};
  EXPECT_NE(changed(shapes, std::array<std::int32_t, 3>{0, 7, 0}).find("grain 1 is of shape 7"), std::string::npos);
}

TEST(FrameFile, TruncatedOrWrong) {
  const Folder folder;
  write_frame(folder / "whole.h5", random_packing({}));
  const std::string whole = bytes_of(folder / "whole.h5");
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 53) {
    put_bytes(folder / "part.h5", whole.substr(0, at));
    EXPECT_NE(error_of([&] { read_frame(folder / "part.h5"); }).find("truncated"), std::string::npos);
    std::string wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] + 1);
    put_bytes(folder / "wrong.h5", wrong);
    EXPECT_NE(error_of([&] { read_frame(folder / "wrong.h5"); }).find("damaged"), std::string::npos);
  }
}

TEST(FrameFile, AFullDiskLeavesNothing) {
  const Folder folder;
  {
    const FullDisk full(10000);
    EXPECT_NE(error_of([&] { write_frame(folder / "frame.h5", random_packing({})); }).find("too large"),
              std::string::npos);
  }
  EXPECT_EQ(folder.files(), 0u);
  error_of([&] { write_frame(folder / "no/such/folder/frame.h5", random_packing({})); });
}

TEST(FrameFile, ManyThreads) {
  const Folder folder;
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < 4; ++t)
    threads.emplace_back([&folder, t] {
      for (unsigned k = 0; k < 5; ++k) {
        const Packing p = random_packing({.dimension = 2 + static_cast<int>(t % 2), .seed = 100 * t + k});
        const auto path = folder / (std::to_string(t) + ".h5");
        write_frame(path, p);
        expect_same(read_frame(path), p);
        EXPECT_THROW(read_frame(folder / "none.h5"), Error);
      }
    });
  for (std::thread& thread : threads) thread.join();
}

TEST(RunFile, KeepsEveryBitOfEveryFrame) {
  for (int dimension : {2, 3}) {
    const Folder folder;
    const auto run = run_of(12, dimension);
    const Paths paths = store(folder, run);
    assemble_run(paths, folder / "run.h5", provenance);
    expect_run(folder / "run.h5", run);
    EXPECT_EQ(RunFile(folder / "run.h5").provenance(), provenance);
    EXPECT_EQ(folder.files(), run.size() + 1);
  }
}

TEST(RunFile, GrainsMayChangeAndGrowInNumber) {
  const Folder folder;
  auto run = run_of(3, 2);
  for (std::size_t grains : {50u, 80u, 20u})
    run.push_back(random_packing({.grains = grains, .seed = static_cast<unsigned>(grains)}));
  assemble_run(store(folder, run), folder / "run.h5", provenance);
  expect_run(folder / "run.h5", run);
}

/// Layers are added: more grains from frame to frame, those there were keep their shapes and sizes.
TEST(RunFile, ClustersMayGrowInNumber) {
  for (int dimension : {2, 3}) {
    const Folder folder;
    std::vector<Packing> run;
    for (std::size_t k = 0; k < 5; ++k) {
      run.push_back(random_packing({.dimension = dimension,
                                    .grains = 300 * (1 + k / 2),
                                    .bead_walls = 0,
                                    .plane_walls = 2,
                                    .seed = static_cast<unsigned>(k + 60),
                                    .shapes = 1}));
      run.back().shapes = run.front().shapes;
      const Grains& first = run.front().grains;
      std::copy(first.scale.begin(), first.scale.end(), run.back().grains.scale.begin());
    }
    assemble_run(store(folder, run), folder / "run.h5", provenance);
    expect_run(folder / "run.h5", run);
    assemble_run({folder / "0.h5", folder / "1.h5"}, folder / "lasting.h5", provenance);
    expect_run(folder / "lasting.h5", {run[0], run[1]});
  }
}

TEST(RunFile, ClustersOfOtherShapesDoNotMix) {
  const Folder folder;
  for (std::size_t shapes : {0u, 2u}) {
    const Paths paths = store(folder, {random_packing({.shapes = 1}), random_packing({.shapes = shapes})});
    EXPECT_NE(error_of([&] { assemble_run(paths, folder / "run.h5", provenance); }).find("other shapes"),
              std::string::npos);
  }
}

/// Files written before there were clusters: see data/README.md.
TEST(RunFile, FilesOfVersion1StillRead) {
  const std::filesystem::path data(IO_DATA);
  expect_run(data / "v1-run.h5", {plain_packing(2, 0), plain_packing(2, 1)});
  expect_same(read_frame(data / "v1-frame.h5"), plain_packing(2, 1));
}

TEST(RunFile, LargerThanAChunk) {
  const Folder folder;
  std::vector<Packing> run;
  for (unsigned k = 0; k < 3; ++k)
    run.push_back(random_packing({.dimension = 3, .grains = 9000, .contacts = 15000, .seed = k}));
  assemble_run(store(folder, run), folder / "run.h5", provenance);
  expect_run(folder / "run.h5", run);
}

TEST(RunFile, EqualContentGivesEqualBytes) {
  const Folder folder;
  const Paths paths = store(folder, run_of(5, 2));
  assemble_run(paths, folder / "a.h5", provenance);
  assemble_run(paths, folder / "b.h5", provenance);
  EXPECT_EQ(bytes_of(folder / "a.h5"), bytes_of(folder / "b.h5"));
}

TEST(RunFile, NoFrames) {
  const Folder folder;
  assemble_run({}, folder / "run.h5", provenance);
  const RunFile file(folder / "run.h5");
  EXPECT_EQ(file.frames(), 0u);
  EXPECT_NE(error_of([&] { static_cast<void>(file.frame(0)); }).find("no frame 0"), std::string::npos);
}

TEST(RunFile, AMissingFrameLeavesTheOldRun) {
  const Folder folder;
  const auto run = run_of(2, 2);
  Paths paths = store(folder, run);
  assemble_run(paths, folder / "run.h5", provenance);
  paths.push_back(folder / "missing.h5");
  EXPECT_NE(error_of([&] { assemble_run(paths, folder / "run.h5", provenance); }).find("missing.h5"),
            std::string::npos);
  expect_run(folder / "run.h5", run);
  EXPECT_EQ(folder.files(), 3u);
}

TEST(RunFile, FramesOfTwoDimensionsDoNotMix) {
  const Folder folder;
  const Paths paths = store(folder, {random_packing({.dimension = 2}), random_packing({.dimension = 3})});
  error_of([&] { assemble_run(paths, folder / "run.h5", provenance); });
  EXPECT_EQ(folder.files(), 2u);
}

TEST(RunFile, AFullDiskLeavesNothing) {
  const Folder folder;
  const auto run = run_of(20, 2);
  const Paths paths = store(folder, run);
  for (rlim_t bytes : {1000u, 20000u, 100000u, 150000u}) {
    {
      const FullDisk full(bytes);
      EXPECT_NE(error_of([&] { assemble_run(paths, folder / "run.h5", provenance); }).find("too large"),
                std::string::npos);
    }
    EXPECT_EQ(folder.files(), run.size());
  }
  assemble_run(paths, folder / "run.h5", provenance);
  expect_run(folder / "run.h5", run);
}

TEST(RunFile, TruncatedOrOfAnotherKind) {
  const Folder folder;
  assemble_run(store(folder, run_of(4, 2)), folder / "run.h5", provenance);
  const std::string whole = bytes_of(folder / "run.h5");
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 53) {
    put_bytes(folder / "part.h5", whole.substr(0, size));
    EXPECT_NE(error_of([&] { RunFile(folder / "part.h5"); }).find("part.h5: "), std::string::npos);
  }
  put_bytes(folder / "text.h5", "i,j,force\n0,1,2\n");
  EXPECT_NE(error_of([&] { RunFile(folder / "text.h5"); }).find("HDF5"), std::string::npos);
  EXPECT_NE(error_of([&] { RunFile(folder / "none.h5"); }).find("No such file"), std::string::npos);
  error_of([&] { RunFile(folder / ""); });
}

using Verdict = RunCheck::Verdict;

TEST(RunFile, EveryTurnedBitIsNamed) {
  const Folder folder;
  assemble_run(store(folder, run_of(2, 2)), folder / "run.h5", provenance);
  EXPECT_EQ(check_run(folder / "run.h5").verdict, Verdict::whole);
  const std::string whole = bytes_of(folder / "run.h5");
  std::mt19937_64 generator(11);
  for (int k = 0; k < 600; ++k) {
    std::string wrong = whole;
    const std::size_t bit = generator() % (8 * whole.size());
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ (1 << bit % 8));
    put_bytes(folder / "wrong.h5", wrong);
    const RunCheck check = check_run(folder / "wrong.h5");
    EXPECT_EQ(check.verdict, Verdict::damaged) << bit;
    EXPECT_NE(check.reason.find("wrong.h5"), std::string::npos);
    EXPECT_NE(error_of([&] { RunFile(folder / "wrong.h5"); }).find("damaged"), std::string::npos);
  }
}

TEST(RunFile, EveryCutIsNamed) {
  const Folder folder;
  assemble_run(store(folder, run_of(2, 2)), folder / "run.h5", provenance);
  const std::string whole = bytes_of(folder / "run.h5");
  for (std::size_t cut = 1; cut <= whole.size(); cut += cut < 60 ? 1 : 997) {
    put_bytes(folder / "cut.h5", whole.substr(0, whole.size() - cut));
    EXPECT_EQ(check_run(folder / "cut.h5").verdict, Verdict::damaged) << cut;
    error_of([&] { RunFile(folder / "cut.h5"); });
  }
  put_bytes(folder / "cut.h5", whole + "x");
  EXPECT_EQ(check_run(folder / "cut.h5").verdict, Verdict::damaged) << "longer";
}

/// Other programs that write into the file leave no seal, or one that does not fit.
TEST(RunFile, AChangeByAnotherProgramIsNamed) {
  const Folder folder;
  const std::vector<Packing> run = run_of(2, 2);
  assemble_run(store(folder, run), folder / "run.h5", provenance);
  std::string bytes = unseal(bytes_of(folder / "run.h5"), "run.h5");
  put_bytes(folder / "run.h5", bytes);
  EXPECT_NE(check_run(folder / "run.h5").reason.find("lost its seal"), std::string::npos);
  put_bytes(folder / "run.h5", seal(bytes));
  EXPECT_EQ(check_run(folder / "run.h5").verdict, Verdict::whole);
  expect_run(folder / "run.h5", run);
}

TEST(RunFile, WhatIsNoDamageIsNotCalledSo) {
  const Folder folder;
  EXPECT_EQ(check_run(folder / "none.h5").verdict, Verdict::unreadable);
  std::filesystem::create_directory(folder / "folder.h5");
  EXPECT_EQ(check_run(folder / "folder.h5").verdict, Verdict::unreadable);
  const std::filesystem::path old = std::filesystem::path(IO_DATA) / "v1-run.h5";
  EXPECT_EQ(check_run(old).verdict, Verdict::not_covered);
}

/// Files without a seal. Whatever byte is wrong: an error, or a packing with valid indices (a wrong byte of padding
/// harms nothing).
TEST(RunFile, AWrongByteNeverCrashes) {
  const Folder folder;
  const std::string whole = bytes_of(std::filesystem::path(IO_DATA) / "v1-run.h5");
  std::size_t noticed = 0, tried = 0;
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 199) {
    std::string wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] ^ 0x55);
    put_bytes(folder / "wrong.h5", wrong);
    ++tried;
    try {
      const RunFile file(folder / "wrong.h5");
      for (std::size_t k = 0; k < file.frames(); ++k) static_cast<void>(file.frame(k));
    } catch (const Error&) {
      ++noticed;
    }
  }
  EXPECT_GT(noticed, tried / 2);
}

}  // namespace
}  // namespace jam
