#include "jamscape/packing/difference.hpp"

#include <algorithm>
#include <cstring>

#include "jamscape/packing/fields.hpp"

namespace jam {
namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
bool same_bits(const std::string& a, const std::string& b) { return a == b; }
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Keeps the name of the first field that differs.
class Comparison {
 public:
  template <class Fields, class Record>
  void records(const std::string& prefix, const Fields& fields, const Record& a, const Record& b) {
    for_each_field(fields, [&](const auto& f) { note(same_bits(a.*f.member, b.*f.member), prefix + f.name); });
  }
  void note(bool same, const std::string& name) {
    if (!same && name_.empty()) name_ = name;
  }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

void compare_shapes(Comparison& found, const ClusterShape& a, const ClusterShape& b) {
  found.records("shapes.", shape_fields, a, b);
  found.note(a.arms.size() == b.arms.size(), "shapes.arms");
  for (std::size_t k = 0; k < std::min(a.arms.size(), b.arms.size()); ++k)
    found.records("shapes.arms.", arm_fields, a.arms[k], b.arms[k]);
}

}  // namespace

std::string first_difference(const Packing& a, const Packing& b) {
  Comparison found;
  found.note(a.dimension == b.dimension, "dimension");
  found.records("", frame_fields, a, b);
  found.records("domain.", domain_fields, a.domain, b.domain);
  found.records("knows.", knowledge_fields, a.knows, b.knows);
  found.note(a.shapes.size() == b.shapes.size(), "shapes");
  for (std::size_t s = 0; s < std::min(a.shapes.size(), b.shapes.size()); ++s)
    compare_shapes(found, a.shapes[s], b.shapes[s]);
  found.records("grains.", grain_fields, a.grains, b.grains);
  found.records("contacts.", contact_fields, a.contacts, b.contacts);
  found.note(a.walls.size() == b.walls.size(), "walls");
  for (std::size_t w = 0; w < std::min(a.walls.size(), b.walls.size()); ++w)
    found.records("walls.", wall_fields, a.walls[w], b.walls[w]);
  found.records("energy.", energy_fields, a.energy, b.energy);
  return found.name();
}

}  // namespace jam
