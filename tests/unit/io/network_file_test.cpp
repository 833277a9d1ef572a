#include "jamscape/io/network_file.hpp"

#include "packings.hpp"

namespace jam {
namespace {

using namespace testing;
using Ids = std::vector<std::int64_t>;
using Vertices = std::vector<std::uint32_t>;

class NetworkFile : public ::testing::Test {
 protected:
  NamedGraph read(const std::string& text) {
    put_bytes(folder_ / "n.csv", text);
    return read_network(folder_ / "n.csv");
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
  expect_graph(read("i,j,force\n70,-3,1.5\n8,70,0\n"), {-3, 8, 70}, {2, 1}, {0, 2}, {1.5, 0});
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
  EXPECT_NE(error("3\n0 1 1\n1 0 2\n").find("n.csv:3: the pair 1, 0 was given before, at "), std::string::npos);
  EXPECT_NE(error("3\n0 1 1\n1 1 2\n").find("n.csv:3: vertex 1 is linked to itself"), std::string::npos);
  EXPECT_NE(error("3\n0 3 1\n").find("n.csv:2:1: vertex 3 is out of range"), std::string::npos);
  EXPECT_NE(error("3\n0 1\n").find("n.csv:2:1: a row holds 2 numbers"), std::string::npos);
  EXPECT_NE(error("3\n0 x 1\n").find("n.csv:2:3: 'x' is no index of a vertex"), std::string::npos);
}

TEST_F(NetworkFile, WrongColumnNames) {
  EXPECT_NE(error("i,j,forse\n0,1,1\n").find("did you mean 'force' by 'forse'?"), std::string::npos);
  EXPECT_NE(error("i,b,force\n0,1,1\n").find("there is no column 'j'"), std::string::npos);
  EXPECT_NE(error("0,1,1\n1,2,3\n").find("the first row holds numbers"), std::string::npos);
  EXPECT_NE(error("i;j;force\n0;1;1\n").find("separate the columns by commas"), std::string::npos);
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
