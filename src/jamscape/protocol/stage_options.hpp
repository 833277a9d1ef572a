// One stage of a protocol ([[stage]] in the study file): which kind, and the options of all kinds. Kinds are listed in
// stages/list.hpp; everything here follows from that list.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "jamscape/protocol/stages/list.hpp"

namespace jam {

#define JAM_STAGE(name, Type) name,
enum class StageKind { JAM_STAGES(JAM_STAGE) };
#undef JAM_STAGE

#define JAM_STAGE(name, Type) {StageKind::name, #name},
template <>
struct EnumNames<StageKind> {
  static constexpr std::pair<StageKind, std::string_view> values[] = {JAM_STAGES(JAM_STAGE)};
};
#undef JAM_STAGE

/// What others ask of a kind of stage.
struct StageInfo {
  StageKind kind;
  std::string_view name;
  StageTraits traits;
  void (*in_box)(const StageOptions&, BoxTimetable&);              ///< nullptr: there is no such stage in a box
  void (*in_container)(const StageOptions&, ContainerTimetable&);  ///< nullptr: nor in a container
};

/// All kinds, in the order of the list.
std::span<const StageInfo> stage_kinds();
const StageInfo& stage_info(StageKind kind);
/// "compress moves all walls inward at constant speed; ...", for the option `kind`.
std::string_view stage_kinds_text();

struct StageHead {
  std::string name;
  StageKind kind = StageKind::compress;
};

/// Done in order.
#define JAM_STAGE(name, Type) , Type::Options
struct StageOptions : StageHead JAM_STAGES(JAM_STAGE) {
#undef JAM_STAGE
  template <class V>
  void describe(V& v) {
    v.option("name", name, {.text = "name of the stage in the tables; its kind and number when empty"});
    v.option("kind", kind, {.text = stage_kinds_text()});
#define JAM_STAGE(name, Type) Type::Options::describe(v);
    JAM_STAGES(JAM_STAGE)
#undef JAM_STAGE
  }

  /// Takes the options that only say where frames are taken back to their defaults.
  void forget_frames();
  const StageTraits& traits() const { return stage_info(kind).traits; }
};

}  // namespace jam
