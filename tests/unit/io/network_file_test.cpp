#include "jamscape/io/network_file.hpp"

#include "packings.hpp"

namespace jam {
namespace {

using namespace testing;
using Ids = std::vector<std::int64_t>;
using Vertices = std::vector<std::uint32_t>;

class NetworkFile : public ::testing::Test {
 protected:
  NamedGraph read(const std::string& text, const NetworkReading& how = {}) {
    put_bytes(folder_ / "n.csv", text);
    return read_network(folder_ / "n.csv", how);
  }
  /// The message after the file's name, or all of it.
  std::string error(const std::string& text) {
    const std::string message = error_of([&] { read(text); });
    const auto at = message.find("n.csv:");
    return at == std::string::npos ? message : message.substr(at);
  }
  Folder folder_;
};

void expect_graph(const NamedGraph& network, const Ids& ids, const Vertices& from, const Vertices& to,
                  const std::vector<double>& weight) {
  EXPECT_EQ(network.ids, ids);
  EXPECT_EQ(network.graph.vertices, ids.size());
  EXPECT_EQ(network.graph.from, from);
  EXPECT_EQ(network.graph.to, to);
  EXPECT_EQ(network.graph.weight, weight);
}

TEST_F(NetworkFile, CsvWithAnyIds) {
  expect_graph(read("i,j,force\n70,3,1.5\n8,70,0\n"), {3, 8, 70}, {2, 1}, {0, 2}, {1.5, 0});
  expect_graph(read("# code: other\r\nFN,x,ID2,ID1\r\n2D0,0,1,0\r\n"), {0, 1}, {0}, {1}, {2});
  expect_graph(read("i,j,force\n"), {}, {}, {}, {});
  expect_graph(read("i,j,force\n\"1\",\"2\",\"0.5\"\n"), {1, 2}, {0}, {1}, {.5});
}

TEST_F(NetworkFile, VerticesWithoutEdgesCount) {
  expect_graph(read("# vertices: 4\ni,j,force\n0,2,1\n"), {0, 1, 2, 3}, {0}, {2}, {1});
  expect_graph(read("# vertices: 3\ni,j,force\n1,3,1\n"), {1, 2, 3}, {0}, {2}, {1});
  expect_graph(read("# vertices: 2\ni,j,force\n"), {0, 1}, {}, {}, {});
  EXPECT_NE(error("# vertices: 3\ni,j,force\n0,1,1\n2,3,1\n").find("n.csv:4:5: vertex 3 is out of range"),
            std::string::npos);
}

TEST_F(NetworkFile, InteractionNetwork) {
  expect_graph(read("4\n0 1 2.5\n\n3\t1  1e-1\r\n"), {0, 1, 2, 3}, {0, 3}, {1, 1}, {2.5, .1});
  expect_graph(read("2\n"), {0, 1}, {}, {}, {});
}

TEST_F(NetworkFile, HugeCountsAreRefused) {
  for (const char* count : {"1000000000000000000", "-1", "99999999999999999999999"}) {
    EXPECT_FALSE(error(std::string("# vertices: ") + count + "\ni,j,force\n0,1,1\n").empty());
    EXPECT_FALSE(error(std::string(count) + "\n0 1 1\n").empty());
  }
}

TEST_F(NetworkFile, WhatIsNoNetwork) {
  EXPECT_EQ(error("i,j,force\n0,1,1\n2,3,4\n1,0,2\n").substr(0, 10), "n.csv:4:5:");
  EXPECT_NE(error("i,j,force\n0,1,1\n2,3,4\n1,0,2\n").find("was given before, at "), std::string::npos);
  EXPECT_NE(error("i,j,force\n0,0,1\n").find("n.csv:2:5: vertex 0 is linked to itself"), std::string::npos);
  EXPECT_NE(error("i,j,force\n0,1,-1\n").find("negative: -1"), std::string::npos);
  EXPECT_NE(error("i,j,force\n0,1,inf\n").find("is inf"), std::string::npos);
  EXPECT_NE(error("i,j,force\n0,1,\n").find("is nan"), std::string::npos);
  EXPECT_NE(error("i,j,force\n0,1.5,1\n").find("n.csv:2:3: '1.5' in column 'j' is no integer"), std::string::npos);
  EXPECT_NE(error("3\n0 1 1\n1 0 2\n").find("n.csv:3:1: the pair 1, 0 was given before, at "), std::string::npos);
  EXPECT_NE(error("3\n0 1 1\n1 1 2\n").find("n.csv:3:1: vertex 1 is linked to itself"), std::string::npos);
  EXPECT_NE(error("3\n0 3 1\n").find("n.csv:2:1: vertex 3 is out of range"), std::string::npos);
  EXPECT_NE(error("3\n0 1\n").find("n.csv:2:1: a row holds 2 numbers"), std::string::npos);
  EXPECT_NE(error("3\n0 x 1\n").find("n.csv:2:3: 'x' is no index of a vertex"), std::string::npos);
}

TEST_F(NetworkFile, WrongColumnNames) {
  EXPECT_NE(error("i,j,forse\n0,1,1\n").find("did you mean 'force' by 'forse'?"), std::string::npos);
  EXPECT_NE(error("i,b,force\n0,1,1\n").find("there is no column 'j'"), std::string::npos);
  EXPECT_NE(error("0,1,1\n1,2,3\n").find("the first row holds numbers"), std::string::npos);
}

bool noted(const NamedGraph& network, const std::string& text) {
  return std::any_of(network.notes.begin(), network.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST_F(NetworkFile, RowsOfWallsAreLeftOutOrKept) {
  const std::string text = "id1,id2,fn\n0,1,1\n1,2,2\n0,-1,5\n2,-1,6\n-2,1,7\n";
  const NamedGraph without = read(text);
  expect_graph(without, {0, 1, 2}, {0, 1}, {1, 2}, {1, 2});
  EXPECT_TRUE(noted(without, "3 of 5 rows are contacts with walls"));
  const NamedGraph with = read(text, {.walls = WallRows::keep});
  expect_graph(with, {-2, -1, 0, 1, 2}, {2, 3, 2, 4, 0}, {3, 4, 1, 1, 3}, {1, 2, 5, 6, 7});
  EXPECT_TRUE(with.notes.empty());
  expect_graph(read("# vertices: 4\ni,j,force\n0,1,1\n3,-1,1\n", {.walls = WallRows::keep}), {-1, 0, 1, 2, 3}, {1, 4},
               {2, 0}, {1, 1});
  // Two beads of one wall push grain 0 with 3 and 4 at a right angle: 5 together.
  const std::string beads = "id1,id2,fn,nx,ny,part2\n0,1,1,1,0,0\n0,-1,3,1,0,7\n0,-1,4,0,1,8\n";
  expect_graph(read(beads, {.walls = WallRows::keep}), {-1, 0, 1}, {1, 1}, {2, 0}, {1, 5});
  EXPECT_NE(
      error_of([&] { read("i,j,force\n0,1,1\n0,-1,1\n0,-1,2\n", {.walls = WallRows::keep}); }).find("was given before"),
      std::string::npos);
}

TEST_F(NetworkFile, RowsThatDoNotTouchAreLeftOut) {
  const NamedGraph network = read("id1,id2,fn,overlap\n0,1,1,0.1\n1,2,0,-0.1\n0,2,0,0\n");
  expect_graph(network, {0, 1, 2}, {0, 0}, {1, 2}, {1, 0});
  EXPECT_TRUE(noted(network, "1 of 3 rows have an overlap below 0"));
  expect_graph(read("id1,id2,fn,overlap\n0,1,1,0.1\n1,2,2,-0.1\n"), {0, 1, 2}, {0, 1}, {1, 2}, {1, 2});
  EXPECT_NE(error("id1,id2,fn,overlap\n0,1,1,-0.1\n").find("turn their sign"), std::string::npos);
}

TEST_F(NetworkFile, SeveralFramesAreRefusedUnlessOneIsAskedFor) {
  const std::string text = "frame,i,j,force\n1,0,1,1\n1,1,2,2\n2,0,1,5\n";
  EXPECT_EQ(error(text).substr(0, 10), "n.csv:4:1:");
  EXPECT_NE(error(text).find("several frames: 1, 2 in column 'frame'"), std::string::npos);
  expect_graph(read(text, {.frame = 2}), {0, 1}, {0}, {1}, {5});
  EXPECT_NE(error_of([&] { read(text, {.frame = 3}); }).find("there is no frame 3"), std::string::npos);
  EXPECT_NE(error_of([&] { read("i,j,force\n0,1,1\n", {.frame = 3}); }).find("no column tells"), std::string::npos);
  expect_graph(read("frame,i,j,force\n7,0,1,1\n"), {0, 1}, {0}, {1}, {1});
}

TEST_F(NetworkFile, TextOfSpreadsheets) {
  const auto same = [&](const std::string& text) { expect_graph(read(text), {0, 1, 2}, {0, 1}, {1, 2}, {2.5, 3.5}); };
  same("i;j;force\n0;1;2,5\n1;2;3,5\n");
  same("sep=;\r\ni;j;force\r\n0;1;2,5\r\n1;2;3,5\r\n;;\r\n");
  same("i;j;force\n0;1;2.5\n1;2;3.5\n");
  same("i\tj\tforce\n0\t1\t2,5\n1\t2\t3,5\n");
  same("i|j|force\n0|1|2.5\n1|2|3.5\n");
  same("\"i\";\"j\";\"force\"\n\"0\";\"1\";\"2,5\"\n1;2;3,5E0\n");
  same("i j force\n0 1 2.5\n1  2 3.5\n");
  same("i,j,force\r0,1,2.5\r1,2,3.5\r");
  same("\xef\xbb\xbfi,j,force\n0,1,2.5\n1,2,3.5\n");
  std::string low("\xff\xfe"), high("\xfe\xff"), unmarked;
  for (const char c : std::string("i,j,force\r\n0,1,2.5\r\n1,2,3.5\r\n")) {
    low += {c, '\0'};
    high += {'\0', c};
    unmarked += {c, '\0'};
  }
  same(low);
  same(high);
  same(unmarked);
  EXPECT_NE(error("i,j,force\n0,1,\"2,5\"\n").find("n.csv:2:5: '2,5' in column 'force' is no number"),
            std::string::npos);
  EXPECT_NE(error("i,j,force\n0,1,\"2,5\"\n").find("semicolons"), std::string::npos);
  EXPECT_NE(error("i,j,force\n0,1,2,5\n").find("decimal commas"), std::string::npos);
  EXPECT_NE(error("i;j;force;x\n0;1;1,234;0.5\n").find("a decimal point"), std::string::npos);
  EXPECT_NE(error("i;j;force\n0;1;1.234,5\n").find("thousands"), std::string::npos);
  EXPECT_NE(error("3\n0 1 2,5\n").find("decimal point"), std::string::npos);
  EXPECT_NE(error(std::string("i,j,force\n0,1,\0\n", 16)).find("no text"), std::string::npos);
}

TEST_F(NetworkFile, NumbersThatLostDigits) {
  EXPECT_NE(error("i,j,force\n6144039378640938.4,1,1\n").find("no integer"), std::string::npos);
  EXPECT_NE(error("i,j,force\n7.2e16,1,1\n").find("all its digits"), std::string::npos);
  EXPECT_NE(error("i,j,force\n1.2E+07,1,1\n").find("all its digits"), std::string::npos);
  EXPECT_EQ(read("i,j,force\n9007199254740993,1.0,1\n").ids, (Ids{1, 9007199254740993}));
  EXPECT_EQ(read("i,j,force\n1.200000000000000000e+07,1e2,1\n").ids, (Ids{100, 12000000}));
}

TEST_F(NetworkFile, RoundTrips) {
  std::mt19937_64 generator(5);
  NamedGraph network;
  network.graph.vertices = 40;
  for (std::int64_t v = 0; v < 40; ++v) network.ids.push_back(v);
  for (std::uint32_t v = 0; v + 3 < 40; ++v) {
    network.graph.from.push_back(v);
    network.graph.to.push_back(v + 1 + static_cast<std::uint32_t>(generator() % 3));
    network.graph.weight.push_back(static_cast<double>(generator()) * 0x1p-60);
  }
  for (const char* name : {"n.csv", "n.csv.gz", "n.csv.zst", "n.txt"}) {
    if (std::string_view(name) == "n.txt")
      write_interaction_network(folder_ / name, network.graph);
    else
      write_network_csv(folder_ / name, network);
    expect_graph(read_network(folder_ / name), network.ids, network.graph.from, network.graph.to, network.graph.weight);
  }
}

}  // namespace
}  // namespace jam
