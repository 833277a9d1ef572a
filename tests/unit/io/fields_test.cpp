// The list of fields: whatever is in it is compared, written and read, to the bit.
#include "jamscape/packing/fields.hpp"

#include <functional>
#include <set>

#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/io/seal.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace testing;

/// One change of a packing, and the name of the field that it is in.
struct Change {
  std::string name;
  std::function<void(Packing&)> make;
};

/// Turns the lowest bit of one number.
template <class T>
void turn_bit(T& number) {
  unsigned char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  bytes[0] ^= 1;
  std::memcpy(&number, bytes, sizeof number);
}
void turn_bit(bool& flag) { flag = !flag; }
void turn_bit(std::string& text) { text += 'x'; }
void turn_bit(WallKind& kind) { kind = kind == WallKind::plane ? WallKind::beads : WallKind::plane; }
void turn_bit(WallRole& role) { role = role == WallRole::lid ? WallRole::side : WallRole::lid; }
void turn_bit(std::array<Vec3, 3>& rows) { turn_bit(rows[1][0]); }
void turn_bit(std::array<bool, 3>& flags) { turn_bit(flags[1]); }
void turn_bit(std::array<std::int8_t, 3>& image) { turn_bit(image[1]); }
void turn_bit(Vec3& v) { turn_bit(v[1]); }
void turn_bit(Quaternion& q) { turn_bit(q.z); }

/// A value of a list of them; a component that is stored.
template <class T>
void turn_bit_of(std::vector<T>& values, FieldShape shape, int dimension) {
  T& last = values.back();
  if constexpr (std::is_same_v<T, Vec3>)
    turn_bit(last[components(shape, dimension).first]);
  else
    turn_bit(last);
}

template <class Fields, class Record>
void add_changes(std::vector<Change>& changes, const std::string& prefix, const Fields& fields, int dimension,
                 const std::function<Record&(Packing&)>& of) {
  for_each_field(fields, [&](const auto& f) {
    changes.push_back({prefix + f.name, [f, of, dimension](Packing& p) {
                         auto& member = of(p).*f.member;
                         if constexpr (requires { turn_bit_of(member, f.shape, dimension); })
                           turn_bit_of(member, f.shape, dimension);
                         else
                           turn_bit(member);
                       }});
  });
}

std::vector<Change> all_changes(int dimension) {
  std::vector<Change> changes;
  add_changes<decltype(frame_fields), Packing>(changes, "", frame_fields, dimension,
                                               [](Packing& p) -> Packing& { return p; });
  add_changes<decltype(domain_fields), Domain>(changes, "domain.", domain_fields, dimension,
                                               [](Packing& p) -> Domain& { return p.domain; });
  add_changes<decltype(knowledge_fields), Knowledge>(changes, "knows.", knowledge_fields, dimension,
                                                     [](Packing& p) -> Knowledge& { return p.knows; });
  add_changes<decltype(energy_fields), EnergyLedger>(changes, "energy.", energy_fields, dimension,
                                                     [](Packing& p) -> EnergyLedger& { return p.energy; });
  add_changes<decltype(grain_fields), Grains>(changes, "grains.", grain_fields, dimension,
                                              [](Packing& p) -> Grains& { return p.grains; });
  add_changes<decltype(contact_fields), Contacts>(changes, "contacts.", contact_fields, dimension,
                                                  [](Packing& p) -> Contacts& { return p.contacts; });
  add_changes<decltype(wall_fields), Wall>(changes, "walls.", wall_fields, dimension,
                                           [](Packing& p) -> Wall& { return p.walls.front(); });
  add_changes<decltype(shape_fields), ClusterShape>(changes, "shapes.", shape_fields, dimension,
                                                    [](Packing& p) -> ClusterShape& { return p.shapes.back(); });
  add_changes<decltype(arm_fields), Arm>(changes, "shapes.arms.", arm_fields, dimension,
                                         [](Packing& p) -> Arm& { return p.shapes.back().arms.back(); });
  return changes;
}

/// Clusters between walls of beads and a cylinder: a packing that has every field.
Packing full_packing(int dimension) {
  Packing p = random_packing({.dimension = dimension, .grains = 7, .contacts = 9, .seed = 77, .shapes = 2});
  p.relaxation = "energy";
  for (auto& shape : p.grains.shape) shape = 1;  // of two arms, so that one bit more is a part there is
  for (auto* parts : {&p.contacts.part_i, &p.contacts.part_j}) std::fill(parts->begin(), parts->end(), 0);
  p.contacts.i.back() = 4;
  p.contacts.j.back() = 0;
  return p;
}

TEST(Fields, EveryBitIsComparedAndKept) {
  for (const int dimension : {2, 3}) {
    const Folder folder;
    const Packing sound = full_packing(dimension);
    ASSERT_EQ(first_difference(sound, full_packing(dimension)), "");
    for (const Change& change : all_changes(dimension)) {
      Packing p = full_packing(dimension);
      change.make(p);
      EXPECT_EQ(first_difference(sound, p), change.name);
      EXPECT_EQ(first_difference(p, sound), change.name);
      write_frame(folder / "frame.h5", p);
      EXPECT_EQ(first_difference(read_frame(folder / "frame.h5"), p), "") << change.name;
      if (change.name.starts_with("shapes.")) continue;  // they are the same in all frames of a run
      write_frame(folder / "first.h5", sound);           // what lasts changes between two frames
      assemble_run({folder / "first.h5", folder / "frame.h5"}, folder / "run.h5", {});
      const RunFile run(folder / "run.h5");
      EXPECT_EQ(first_difference(run.frame(0), sound), "") << change.name;
      EXPECT_EQ(first_difference(run.frame(1), p), "") << change.name;
    }
  }
}

TEST(Fields, WhatIsMissingIsSeen) {
  const Packing sound = full_packing(2);
  const std::pair<const char*, std::function<void(Packing&)>> changes[] = {
      {"dimension", [](Packing& p) { p.dimension = 3; }},
      {"walls", [](Packing& p) { p.walls.clear(); }},
      {"shapes", [](Packing& p) { p.shapes.clear(); }},
      {"shapes.arms", [](Packing& p) { p.shapes[1].arms.pop_back(); }},
      {"grains.id", [](Packing& p) { p.grains.id.pop_back(); }},
      {"grains.position", [](Packing& p) { p.grains.position[0][1] = -p.grains.position[0][1]; }},
      {"contacts.normal", [](Packing& p) { p.contacts.normal.clear(); }}};
  for (const auto& [name, change] : changes) {
    Packing p = sound;
    change(p);
    EXPECT_EQ(first_difference(sound, p), name);
  }
}

TEST(Fields, HaveNamesOfTheirOwn) {
  std::set<std::string> names, stored;
  std::size_t count = 0;
  for_each_field(grain_fields, [&](const auto& f) { names.insert(f.name), stored.insert(f.in_file()), ++count; });
  EXPECT_EQ(names.size(), count);
  EXPECT_EQ(stored.size(), count);
}

/// Upright cells stay readable for programs that know no others.
TEST(Fields, OnlyATiltedCellNeedsANewLayout) {
  const auto layout = [](const Packing& p) {
    const Folder folder;
    write_frame(folder / "frame.h5", p);
    expect_same(read_frame(folder / "frame.h5"), p);
    const auto file = hdf5::File::open_image(unseal(bytes_of(folder / "frame.h5"), "frame.h5"), "frame.h5");
    return file.root().read_attribute<std::int32_t>("layout_version");
  };
  Packing p = full_packing(3);
  EXPECT_EQ(layout(p), std::vector<std::int32_t>{2});
  p.domain.tilt[1][0] = 0.5;
  EXPECT_EQ(layout(p), std::vector<std::int32_t>{3});
}

}  // namespace
}  // namespace jam
