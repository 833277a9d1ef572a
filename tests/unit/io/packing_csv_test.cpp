#include "jamscape/io/packing_csv.hpp"

#include <algorithm>
#include <numbers>
#include <sstream>

#include "packings.hpp"

namespace jam {
namespace {

using namespace testing;

/// A packing as a simulation would store it: sorted, with unit normals along the lines of centres, tangential forces
/// across them, plane walls. All grains lie about one place on the border of a periodic box.
Packing sane_packing(int dimension, unsigned seed) {
  Packing p = random_packing({.dimension = dimension, .bead_walls = 0, .plane_walls = 4, .seed = seed});
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  const auto unit = [&] {
    const Vec3 n{normal(generator), normal(generator), dimension == 3 ? normal(generator) : 0};
    return (1 / norm(n)) * n;
  };
  Grains& g = p.grains;
  std::sort(g.id.begin(), g.id.end());
  p.domain.lo = {-3, -3, -3};
  p.domain.hi = {3, 3, 3};
  p.domain.periodic = {true, false, false};
  std::vector<std::int8_t> right;  // grains at the right side of the box
  for (std::size_t n = 0; n < g.size(); ++n) {
    g.radius[n] = 0.5 + std::abs(normal(generator));
    g.mass[n] = std::abs(g.mass[n]);
    g.position[n] = 0.7 * unit();
    right.push_back(g.position[n][0] < 0);
    g.position[n][0] += right[n] ? 3 : -3;
  }
  for (Wall& wall : p.walls) wall.normal = unit();
  p.stage = "press 1";
  p.contacts = {};
  for (std::size_t m = 0; m < 80; ++m) {
    Contacts& c = p.contacts;
    const std::size_t i = m / 2, j = i + 1 + m % 5, w = m % 4;
    const bool wall = m % 2 == 0;
    c.i.push_back(static_cast<std::uint32_t>(i));
    c.j.push_back(wall ? -1 - static_cast<std::int32_t>(w) : static_cast<std::int32_t>(j));
    c.part_i.push_back(0);
    c.part_j.push_back(static_cast<std::uint16_t>(wall ? m : 0));
    c.image.push_back({static_cast<std::int8_t>(wall ? 0 : right[i] - right[j]), 0, 0});
    Vec3 lever = wall ? Vec3{} - p.walls[w].normal : g.position[j] - g.position[i];
    lever[0] += 6 * c.image.back()[0];
    const Vec3 n = (1 / norm(lever)) * lever;
    c.normal.push_back(n);
    c.tangential_force.push_back(dimension == 2 ? Vec3{-n[1], n[0], 0} : cross(n, Vec3{0, 0, 1}));
    c.point.push_back(g.position[i] + 0.9 * g.radius[i] * n);
    c.overlap.push_back(std::abs(normal(generator)));
    c.normal_force.push_back(normal(generator));
    c.sliding.push_back(static_cast<std::uint8_t>(m % 3 == 0));
  }
  for (std::size_t w = 0; w < p.walls.size(); ++w) p.walls[w].force = Vec3{};
  for (std::size_t m = 0; m < p.contacts.size(); ++m)
    if (p.contacts.j[m] < 0)
      p.walls[static_cast<std::size_t>(-1 - p.contacts.j[m])].force +=
          p.contacts.normal_force[m] * p.contacts.normal[m] - p.contacts.tangential_force[m];
  return p;
}

/// The lines of a table in another order; the leading ones stay.
std::string shuffled(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> head, rows;
  for (std::string line; std::getline(in, line);)
    (head.empty() || head.back()[0] == '#' ? head : rows).push_back(line + "\r\n");
  std::shuffle(rows.begin(), rows.end(), std::mt19937_64(9));
  std::string out;
  for (const auto* lines : {&head, &rows})
    for (const std::string& line : *lines) out += line;
  return out;
}

class PackingCsv : public ::testing::Test {
 protected:
  ImportedPacking read(const std::string& particles, const std::string& contacts) {
    put_bytes(folder_ / "p.csv", particles);
    put_bytes(folder_ / "c.csv", contacts);
    return read_packing_csv(folder_ / "p.csv", folder_ / "c.csv");
  }
  std::string error(const std::string& particles, const std::string& contacts) {
    return error_of([&] { read(particles, contacts); });
  }
  bool noted(const ImportedPacking& imported, const std::string& text) {
    return std::any_of(imported.notes.begin(), imported.notes.end(),
                       [&](const std::string& note) { return note.find(text) != std::string::npos; });
  }
  Folder folder_;
};

const std::string two = "id,x,y,radius\n7,0,0,0.5\n9,0.9,0,0.5\n";

TEST_F(PackingCsv, KeepsEveryBit) {
  for (int dimension : {2, 3}) {
    const Packing p = sane_packing(dimension, 3);
    for (const char* ending : {".csv", ".csv.gz", ".csv.zst"}) {
      const auto particles = folder_ / (std::string("p") + ending), contacts = folder_ / (std::string("c") + ending);
      write_packing_csv(p, particles, contacts);
      const ImportedPacking imported = read_packing_csv(particles, contacts);
      expect_same(imported.packing, p);
      EXPECT_TRUE(imported.notes.empty());
    }
  }
}

/// A packing of clusters whose numbers a table can hold.
Packing sane_clusters(int dimension) {
  Packing p = sane_packing(dimension, 5);
  std::mt19937_64 generator(9);
  make_clusters(p, 3, generator);
  return p;
}

TEST_F(PackingCsv, KeepsClusters) {
  for (int dimension : {2, 3}) {
    const Packing p = sane_clusters(dimension);
    write_packing_csv(p, folder_ / "p.csv", folder_ / "c.csv");
    const ImportedPacking imported = read_packing_csv(folder_ / "p.csv", folder_ / "c.csv");
    expect_same(imported.packing, p);
    EXPECT_TRUE(imported.notes.empty());
  }
}

TEST_F(PackingCsv, ClustersThatDoNotFit) {
  write_packing_csv(sane_clusters(2), folder_ / "p.csv", folder_ / "c.csv");
  const std::string particles = bytes_of(folder_ / "p.csv"), contacts = bytes_of(folder_ / "c.csv");
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  const auto says = [&](const std::string& p, const std::string& c, const char* message) {
    const std::string error = error_of([&] { read(p, c); });
    EXPECT_NE(error.find(message), std::string::npos) << error;
  };
  says(replaced(particles, "# shape: ", "# shape: 1 "), contacts, "eight for each arm");
  says(replaced(particles, ",qz", ",qzz"), contacts, "the orientation of a grain");
  says(replaced(particles, "# shape: ", "# form: "), contacts, "is of shape 2, but there are 2 shapes");
  says(replaced(particles, "# shape: ", "# shapes: "), contacts, "did you mean '# shape: value'?");
  says(particles, replaced(contacts, ",overlap", ",depth"), "clusters need them");
}

TEST_F(PackingCsv, RowsMayStandInAnyOrderAndEndInReturns) {
  const Packing p = sane_packing(2, 4);
  write_packing_csv(p, folder_ / "p.csv", folder_ / "c.csv");
  Packing found = read(shuffled(bytes_of(folder_ / "p.csv")), shuffled(bytes_of(folder_ / "c.csv"))).packing;
  for (std::size_t w = 0; w < p.walls.size(); ++w) {  // the order of the sum is another
    EXPECT_NEAR(norm(found.walls[w].force - p.walls[w].force), 0, 1e-12);
    found.walls[w].force = p.walls[w].force;
  }
  expect_same(found, p);
}

TEST_F(PackingCsv, TheLeastThereCanBe) {
  const ImportedPacking imported = read(two, "id1,id2,fn\n9,7,2.5\n");
  const Packing& p = imported.packing;
  EXPECT_EQ(p.dimension, 2);
  EXPECT_EQ(p.grains.id, (std::vector<std::int64_t>{7, 9}));
  EXPECT_EQ(p.grains.mass, (std::vector<double>{1, 1}));
  ASSERT_EQ(p.contacts.size(), 1u);
  EXPECT_EQ(p.contacts.i[0], 0u);
  EXPECT_EQ(p.contacts.j[0], 1);
  EXPECT_EQ(p.contacts.normal_force[0], 2.5);
  EXPECT_EQ(p.contacts.normal[0], (Vec3{1, 0, 0}));
  EXPECT_NEAR(p.contacts.overlap[0], .1, 1e-15);
  EXPECT_NEAR(norm(p.contacts.point[0] - Vec3{.45, 0, 0}), 0, 1e-15);
  EXPECT_EQ(p.domain.lo, (Vec3{-.5, -.5, 0}));
  EXPECT_EQ(p.domain.hi, (Vec3{1.4, .5, 0}));
  EXPECT_NEAR(p.packing_fraction, 2 * std::numbers::pi / 4 / 1.9, 1e-15);
  EXPECT_EQ(p.packing_fraction_plain, p.packing_fraction);
  EXPECT_TRUE(noted(imported, "no box is given"));
  EXPECT_TRUE(noted(imported, "no masses are given"));
}

TEST_F(PackingCsv, ForceVectorsAndOtherNames) {
  // The force on id1: pushed away from the other grain by 2, and to +y by 0.5.
  const Packing p =
      read("Particle,X,Y,Diameter,Type\n1,0,0,1,3\n2,1,0,1,4\n", "Particle1,Particle2,Fx,Fy\n1,2,-2,0.5\n").packing;
  EXPECT_EQ(p.grains.radius, (std::vector<double>{.5, .5}));
  EXPECT_EQ(p.grains.species, (std::vector<std::int32_t>{3, 4}));
  EXPECT_EQ(p.contacts.normal_force[0], 2);
  EXPECT_EQ(p.contacts.tangential_force[0], (Vec3{0, .5, 0}));
}

TEST_F(PackingCsv, ScalarTangentialForcePointsLeftOfTheNormal) {
  const Packing p = read(two, "id1,id2,fn,ft\n9,7,1,0.25\n").packing;
  // On grain 9 the normal is -x, left of it is -y; grain 7 feels the opposite.
  EXPECT_EQ(p.contacts.tangential_force[0], (Vec3{0, .25, 0}));
  const std::string three = "id,x,y,z,radius\n7,0,0,0,0.5\n9,0.9,0,0.1,0.5\n";
  EXPECT_TRUE(noted(read(three, "id1,id2,fn,ft\n9,7,1,0.25\n"), "need the columns ftx"));
}

TEST_F(PackingCsv, MirroredRowsAreAveraged) {
  const ImportedPacking imported = read(two, "id1,id2,fn,ft\n9,7,1,0.5\n7,9,2,0.5\n");
  ASSERT_EQ(imported.packing.contacts.size(), 1u);
  EXPECT_EQ(imported.packing.contacts.normal_force[0], 1.5);
  EXPECT_EQ(imported.packing.contacts.tangential_force[0], (Vec3{0, .5, 0}));
  EXPECT_TRUE(noted(imported, "1 of 1 contacts are given from both sides"));
  EXPECT_NE(error(two, "id1,id2,fn\n7,9,1\n9,7,1\n7,9,3\n").find("was given before"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn\n7,9,1\n7,9,2\n").find("c.csv:3:1: the contact of 7 and 9 was given before, at "),
            std::string::npos);
  EXPECT_EQ(read(two, "id1,id2,fn,part1\n7,9,1,0\n7,9,2,1\n").packing.contacts.size(), 2u);
}

TEST_F(PackingCsv, Walls) {
  const ImportedPacking known = read(two, "# wall: -0.4 0 0 1 0 0 0 0 0\nid1,id2,fn,nx,ny\n7,-1,3,-1,0\n7,9,3,1,0\n");
  ASSERT_EQ(known.packing.walls.size(), 1u);
  EXPECT_EQ(known.packing.walls[0].normal, (Vec3{1, 0, 0}));
  EXPECT_EQ(known.packing.walls[0].force, (Vec3{-3, 0, 0}));
  const ImportedPacking unknown = read(two, "id1,id2,fn,x,y\n7,-2,3,-0.5,0\n");
  ASSERT_EQ(unknown.packing.walls.size(), 2u);
  EXPECT_EQ(unknown.packing.walls[1].normal, (Vec3{1, 0, 0}));
  EXPECT_EQ(unknown.packing.contacts.j[0], -2);
  EXPECT_TRUE(noted(unknown, "known by their contacts only"));
  EXPECT_NE(error(two, "id1,id2,fn\n7,-1,3\n").find("direction of a contact with a wall"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn,nx,ny\n-1,7,3,1,0\n").find("there is no grain -1"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn\n7,-1000000000000000000,3\n").find("there is no grain"), std::string::npos);
}

TEST_F(PackingCsv, PeriodicBoxes) {
  const std::string box = "# lo: 0 0 0\n# hi: 10 10 0\n# periodic: 1 0 0\nid,x,y,radius\n";
  const Packing p = read(box + "1,0.2,5,0.5\n2,9.3,5,0.5\n", "id1,id2,fn\n1,2,1\n").packing;
  EXPECT_EQ(p.contacts.image[0], (std::array<std::int8_t, 3>{-1, 0, 0}));
  EXPECT_NEAR(p.contacts.overlap[0], .1, 1e-14);
  EXPECT_EQ(p.contacts.normal[0], (Vec3{-1, 0, 0}));
  const Packing other = read(box + "1,0.2,5,0.5\n2,9.3,5,0.5\n", "id1,id2,fn,sx,sy\n2,1,1,1,0\n").packing;
  EXPECT_EQ(other.contacts.image, p.contacts.image);
  EXPECT_NEAR(norm(other.contacts.point[0] - p.contacts.point[0]), 0, 1e-14);
  EXPECT_NE(error("# lo: 0 0 0\n# hi: 3 9 0\n# periodic: 1 0 0\nid,x,y,radius\n1,0,0,1\n2,1,1,1\n", "id1,id2,fn\n")
                .find("narrower than two grains along x"),
            std::string::npos);
}

TEST_F(PackingCsv, ForcesOnEveryGrainAreTheSumOfItsContacts) {
  const Packing p = sane_packing(2, 8);
  write_packing_csv(p, folder_ / "p.csv", folder_ / "c.csv");
  const Packing q = read_packing_csv(folder_ / "p.csv", folder_ / "c.csv").packing;
  const auto total = [](const Packing& packing) {
    std::vector<Vec3> force(packing.grains.size(), Vec3{});
    const Contacts& c = packing.contacts;
    for (std::size_t m = 0; m < c.size(); ++m) {
      const Vec3 on_i = c.tangential_force[m] - c.normal_force[m] * c.normal[m];
      force[c.i[m]] += on_i;
      if (c.j[m] >= 0) force[static_cast<std::size_t>(c.j[m])] -= on_i;
    }
    return force;
  };
  EXPECT_TRUE(same_bits(total(p), total(q)));
}

TEST_F(PackingCsv, ErrorsSayWhereAndWhatToTry) {
  const std::string contacts = "id1,id2,fn\n";
  EXPECT_NE(error("id,x,y,radiu\n1,0,0,1\n", contacts).find("did you mean 'radius' by 'radiu'?"), std::string::npos);
  EXPECT_NE(error("idx,x,y,radius\n1,0,0,1\n", contacts).find("there is no column 'id'"), std::string::npos);
  EXPECT_NE(error("id,x,radius\n1,0,1\n", contacts).find("there is no column 'y'"), std::string::npos);
  EXPECT_NE(error("id,x,y,radius\n1,0,0,1\n2,0,0,1\n1,3,3,1\n", contacts).find("p.csv:4:1: grain 1 was given before"),
            std::string::npos);
  EXPECT_NE(error("id,x,y,radius\n1,0,0,-1\n", contacts).find("p.csv:2:7: '-1' in column 'radius' is no size"),
            std::string::npos);
  EXPECT_NE(error("id,x,y,radius\n1,0,nan,1\n", contacts).find("p.csv:2:5: 'nan' in column 'y' is no finite"),
            std::string::npos);
  EXPECT_NE(error("# lo: 0 0 0\nid,x,y,radius\n1,0,0,1\n", contacts).find("the box is given in part"),
            std::string::npos);
  EXPECT_NE(error("# step: x\nid,x,y,radius\n1,0,0,1\n", contacts).find("the step 'x'"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fm\n").find("did you mean 'fn' by 'fm'?"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn\n7,8,1\n").find("c.csv:2:3: there is no grain 8"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn\n7,7,1\n").find("c.csv:2:3: grain 7 touches itself"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn\n7,9,\n").find("c.csv:2:5: '' in column 'fn' is no finite"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn\n7,9\n").find("c.csv:2:1: a row has 2 fields"), std::string::npos);
  EXPECT_NE(error_of([&] { read_packing_csv(folder_ / "none.csv", folder_ / "c.csv"); }).find("none.csv"),
            std::string::npos);
  EXPECT_FALSE(error_of([&] { read_packing_csv(folder_ / "", folder_ / "c.csv"); }).empty());
}

TEST_F(PackingCsv, ListedContactsExistWhateverRoundingSays) {
  // Six digits at x = 1000 open a gap of a millionth; the second pair is pressed and apart; the third is a neighbour.
  const std::string grains = "id,x,y,radius\n1,0,0,0.5\n2,1.000001,0,0.5\n3,0,1.02,0.5\n4,0,-1.02,0.5\n";
  const ImportedPacking imported = read(grains, "id1,id2,fn\n1,2,0\n1,3,2\n1,4,0\n");
  EXPECT_EQ(imported.packing.contacts.overlap[0], 0);
  EXPECT_EQ(imported.packing.contacts.overlap[1], 0);
  EXPECT_NEAR(imported.packing.contacts.overlap[2], -.02, 1e-15);
  EXPECT_TRUE(noted(imported, "2 of 3 listed contacts have a gap at the positions given, up to 0.02"));
  EXPECT_TRUE(noted(imported, "1 of 3 listed pairs carry no force and are apart"));
  // What is stated is believed.
  EXPECT_EQ(read(grains, "id1,id2,fn,overlap\n1,2,1,-0.1\n1,3,1,0.2\n").packing.contacts.overlap,
            (std::vector<double>{-.1, .2}));
  EXPECT_NE(error(grains, "id1,id2,fn,overlap\n1,2,1,-0.1\n1,3,1,-0.2\n").find("overlaps are positive"),
            std::string::npos);
}

TEST_F(PackingCsv, LeversLongerThanGrainsReach) {
  const std::string apart = "id,x,y,radius\n1,0.2,5,0.5\n2,9.3,5,0.5\n", contacts = "id1,id2,fn\n1,2,1\n";
  const std::string missing = error(apart, contacts);
  EXPECT_NE(missing.find("c.csv:2:1: grains 1 and 2 are listed as touching, but their centres are 9.1 apart"),
            std::string::npos)
      << missing;
  EXPECT_NE(missing.find("'# periodic: 1 1 0' on top of the table of particles"), std::string::npos);
  const std::string box = "# lo: 0 0 0\n# hi: 10 10 0\n";
  for (const char* line :
       {"# periodc: 1 0 0\n", "# periodic 1 0 0\n", "# Periodic = 1 0 0\n", "# pbc: 1 0 0\n", "# boundary p f p\n",
        "# periodic: yes no no\n", "# periodic: 2 0 0\n", "# wall: 1\n", "# periodic: 1 0 0\n# periodic: 0 0 0\n"}) {
    const std::string text = error(box + line + apart, contacts);
    EXPECT_NE(text.find("p.csv:"), std::string::npos) << line << text;
    EXPECT_EQ(text.find("centres"), std::string::npos) << line << text;
    EXPECT_NE(text.find("try: "), std::string::npos) << line << text;
  }
  EXPECT_EQ(read(box + "#PERIODIC:1 0\n# made by hand: in a lab\n# periodically sheared\n" + apart, contacts)
                .packing.contacts.image[0][0],
            -1);
  EXPECT_NE(error(apart, "# periodic: 1 0 0\n" + contacts).find("move it to the table of particles"),
            std::string::npos);
}

TEST_F(PackingCsv, NormalsFromTheSecondGrainToTheFirstAreRefused) {
  const std::string all = error(two, "id1,id2,fn,nx,ny\n7,9,1,-1,0\n");
  EXPECT_NE(all.find("c.csv:2:1: the normal of the contact of grains 7 and 9 points away"), std::string::npos) << all;
  EXPECT_NE(all.find("nx, ny (and nz) point from id1 to id2"), std::string::npos);
  const std::string three = "id,x,y,radius\n1,0,0,0.5\n2,0.9,0,0.5\n3,0,0.9,0.5\n";
  EXPECT_NE(error(three, "id1,id2,fn,nx,ny\n1,2,1,-1,0\n3,1,1,0,1\n").find("2 of 2 normals point away"),
            std::string::npos);
  EXPECT_NE(error(three, "id1,id2,fx,fy\n1,2,1,0\n1,3,0,2\n").find("force on id1"), std::string::npos);
  EXPECT_NE(error(three, "id1,id2,fn,fx,fy\n1,2,1,1,0\n").find("opposite signs"), std::string::npos);
  EXPECT_EQ(read(three, "id1,id2,fn,fx,fy\n1,2,1,-1,0.5\n").packing.contacts.tangential_force[0], (Vec3{0, .5, 0}));
  EXPECT_NE(error(two, "# wall: -0.5 0 0 1 0 0 0 0 0\nid1,id2,fn,nx,ny\n7,-1,3,1,0\n").find("points away"),
            std::string::npos);
  const ImportedPacking off = read(two, "id1,id2,fn,nx,ny\n7,9,1,0.8,0.6\n");
  EXPECT_EQ(off.packing.contacts.normal[0], (Vec3{.8, .6, 0}));
  EXPECT_TRUE(noted(off, "37 degrees off"));
  EXPECT_NE(error(two, "id1,id2,fn,x,y\n7,9,1,40,0\n").find("lies 40 from the centre of grain 7"), std::string::npos);
}

TEST_F(PackingCsv, PairsThatTouchThroughBothSides) {
  const std::string grains =
      "# dimension: 2\n# lo: 0 0 0\n# hi: 1.9 10 0\n# periodic: 1 0 0\nid,x,y,radius\n1,0,5,0.5\n"
      "2,0.95,5,0.5\n";
  for (const char* contacts :
       {"id1,id2,fn,sx,sy\n1,2,1.0,0,0\n1,2,1.0,-1,0\n", "id1,id2,fn,sx,sy\n1,2,1.0,0,0\n2,1,3.0,1,0\n"}) {
    const std::string text = error(grains, contacts);
    EXPECT_NE(text.find("c.csv:"), std::string::npos) << text;
    EXPECT_NE(text.find("through both sides of the periodic box, which is only 1.9 wide along x"), std::string::npos)
        << text;
  }
  EXPECT_EQ(read(grains, "id1,id2,fn,sx,sy\n1,2,1.0,0,0\n2,1,3.0,0,0\n").packing.contacts.normal_force,
            (std::vector<double>{2}));
  EXPECT_NE(error(grains, "id1,id2,fn,sx,sy\n1,1,1.0,1,0\n").find("too narrow"), std::string::npos);
}

TEST_F(PackingCsv, LayersOfOneHeightAreDiscs) {
  const std::string rows = "7,0,0,0.5,0.5\n9,0.9,0,0.5,0.5\n", contacts = "id1,id2,fn\n7,9,1\n";
  const ImportedPacking flat = read("id,x,y,z,radius\n" + rows, contacts);
  EXPECT_EQ(flat.packing.dimension, 2);
  EXPECT_EQ(flat.packing.grains.position[1], (Vec3{.9, 0, 0}));
  EXPECT_TRUE(noted(flat, "all grains lie at z = 0.5"));
  EXPECT_EQ(read("# dimension: 3\nid,x,y,z,radius\n" + rows, contacts).packing.dimension, 3);
  EXPECT_EQ(read("# dimension: 2\nid,x,y,z,radius\n" + rows, contacts).packing.dimension, 2);
  const ImportedPacking told = read("# dimension: 2\nid,x,y,z,radius\n7,0,0,0.5,0.5\n9,0.9,0,0.7,0.5\n", contacts);
  EXPECT_TRUE(noted(told, "z, from 0.5 to 0.7, is left out"));
  EXPECT_NE(error("id,x,y,z,radius\n" + rows, "id1,id2,fn,nx,ny,nz\n7,9,1,0.8,0,0.6\n").find("leaves the plane"),
            std::string::npos);
}

TEST_F(PackingCsv, FramesAreNotMixed) {
  const std::string frames = "frame,id1,id2,fn\n1,7,9,1\n2,9,7,9\n";
  EXPECT_NE(error(two, frames).find("c.csv:3:1: the table holds several frames: 1, 2"), std::string::npos);
  const auto of = [&](double frame) {
    return read_packing(CsvFile::parse(two, "p.csv"), CsvFile::parse(frames, "c.csv"), frame)
        .packing.contacts.normal_force;
  };
  EXPECT_EQ(of(1), (std::vector<double>{1}));
  EXPECT_EQ(of(2), (std::vector<double>{9}));
  EXPECT_NE(error("frame,id,x,y,radius\n3,7,0,0,0.5\n3,9,0.9,0,0.5\n", "frame,id1,id2,fn\n1,7,9,1\n")
                .find("the grains are of frame 3, the contacts of frame 1"),
            std::string::npos);
  const ImportedPacking one = read(two, "frame,id1,id2,ft,fn\n1,9,7,0.05,1.2\n1,7,9,0.05,1.0\n");
  EXPECT_NEAR(one.packing.contacts.normal_force[0], 1.1, 1e-15);
  EXPECT_TRUE(noted(one, "given from both sides"));
}

TEST_F(PackingCsv, WhatCannotBe) {
  const std::string contacts = "id1,id2,fn\n7,9,1\n";
  EXPECT_NE(error("id,x,y,radius\n", "id1,id2,fn\n").find("there are no grains"), std::string::npos);
  EXPECT_NE(error("# lo: 5 0 0\n# hi: 5 9 0\n" + two, contacts).find("p.csv:1:1: the box has no room along x"),
            std::string::npos);
  EXPECT_NE(
      error("# lo: -1 -1 0\n# hi: 0.5 9 0\n" + two, contacts).find("p.csv:5:1: grain 9 lies outside the box: x = 0.9"),
      std::string::npos);
  EXPECT_NE(
      error("id,x,y,radius,mass\n7,0,0,0.5,1\n9,0.9,0,0.5,-1\n", contacts).find("p.csv:3:1: grain 9 has the mass -1"),
      std::string::npos);
  EXPECT_NE(error("id,x,y,radius\n6144039378640938.4,0,0,0.5\n", contacts).find("no integer"), std::string::npos);
  EXPECT_NE(error(two, "id1,id2,fn,fty\n7,9,1,1\n").find("there is no column 'ftx'"), std::string::npos);
}

TEST_F(PackingCsv, WhatNothingReadsIsNamed) {
  const ImportedPacking read_ =
      read("# code: other\nid,x,y,radius,charge\n7,0,0,0.5,1\n9,0.9,0,0.5,1\n", "id1,id2,fn,f_shear\n7,9,1,0.5\n");
  EXPECT_TRUE(noted(read_, "lines that nothing reads: # code"));
  EXPECT_TRUE(noted(read_, "columns of particles that nothing reads: charge"));
  EXPECT_TRUE(noted(read_, "if 'f_shear' is a tangential force, name it ft"));
}

TEST_F(PackingCsv, GrainsFarOutsideAPeriodicBoxAreMovedIn) {
  const std::string box = "# lo: 0 0 0\n# hi: 10 10 0\n# periodic: 1 0 0\nid,x,y,radius\n";
  const ImportedPacking imported = read(box + "1,20.2,5,0.5\n2,-0.7,5,0.5\n", "id1,id2,fn\n1,2,1\n");
  const Packing& p = imported.packing;
  EXPECT_NEAR(p.grains.position[0][0], .2, 1e-14);
  EXPECT_NEAR(p.grains.position[1][0], 9.3, 1e-14);
  EXPECT_EQ(p.contacts.image[0], (std::array<std::int8_t, 3>{-1, 0, 0}));
  EXPECT_NEAR(p.contacts.overlap[0], .1, 1e-14);
  EXPECT_NEAR(p.contacts.point[0][0], -.25, 1e-14);
  EXPECT_TRUE(noted(imported, "2 grains lie outside the periodic box"));
}

TEST_F(PackingCsv, RoomOfClustersCountsTheirOverlapOnce) {
  // A cross of unit discs' width and length 3 in the plane: two stadia of 2 + pi/4 less the middle square.
  Packing p;
  ClusterShape cross_{
      "cross", {{{}, {1, 0, 0}, 1, .5}, {{}, {0, 1, 0}, 1, .5}}, 0, 0, 2 * (2 + std::numbers::pi / 4) - 1, {1, 1, 1}, 3,
      1.5};
  cross_.volume = 4;
  p.shapes = {cross_};
  p.grains.id = {1};
  p.grains.species = {0};
  p.grains.radius = {3};
  p.grains.mass = {1};
  p.grains.position = p.grains.velocity = p.grains.spin = p.grains.angle = {{5, 5, 0}};
  p.grains.shape = {0};
  p.grains.scale = {2};
  p.grains.orientation = {{1, 0, 0, 0}};
  p.domain.hi = {10, 10, 0};
  write_packing_csv(p, folder_ / "p.csv", folder_ / "c.csv");
  std::string text = bytes_of(folder_ / "p.csv");
  for (const char* line : {"# packing_fraction: 0\n", "# packing_fraction_plain: 0\n"})
    text.erase(text.find(line), std::string_view(line).size());
  const Packing q = read(text, bytes_of(folder_ / "c.csv")).packing;
  EXPECT_NEAR(q.packing_fraction, 4 * cross_.area / 100, 1e-15);
}

}  // namespace
}  // namespace jam
