#include "jamscape/protocol/stage_options.hpp"

namespace jam {
namespace {

template <class Stage>
constexpr StageInfo info_of(StageKind kind, std::string_view name) {
  StageInfo info{kind, name, Stage::traits, nullptr, nullptr};
  if constexpr (requires(const StageOptions& stage, BoxTimetable& table) { Stage::write(stage, table); })
    info.in_box = &Stage::write;
  if constexpr (requires(const StageOptions& stage, ContainerTimetable& table) { Stage::write(stage, table); })
    info.in_container = &Stage::write;
  return info;
}

#define JAM_STAGE(name, Type) info_of<Type>(StageKind::name, #name),
constexpr StageInfo all[] = {JAM_STAGES(JAM_STAGE)};
#undef JAM_STAGE

template <class Options>
void forget_frames_of(Options& options) {
  if constexpr (requires { options.forget_frames(); }) options.forget_frames();
}

}  // namespace

std::span<const StageInfo> stage_kinds() { return all; }

const StageInfo& stage_info(StageKind kind) { return all[static_cast<std::size_t>(kind)]; }

std::string_view stage_kinds_text() {
  static const std::string text = [] {
    std::string box, container;
    for (const StageInfo& s : all)
      (s.in_box ? box : container) += (s.in_box ? "; " : ", ") + std::string(s.name) + " " + std::string(s.traits.text);
    return "what is done: " + box.substr(2) + "; in a container only: " + container.substr(2);
  }();
  return text;
}

void StageOptions::forget_frames() {
#define JAM_STAGE(name, Type) forget_frames_of<Type::Options>(*this);
  JAM_STAGES(JAM_STAGE)
#undef JAM_STAGE
}

}  // namespace jam
