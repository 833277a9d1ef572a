#include "jamscape/study/time_spent.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace jam {

TimeSpent time_spent(const TaskFolder& folder) noexcept try {
  TimeSpent spent;
  std::ifstream log(folder.path() / "log.jsonl");
  for (std::string text; std::getline(log, text);) {
    const auto line = nlohmann::json::parse(text, nullptr, false);
    if (!line.is_object() || !line.contains("seconds")) continue;
    const double seconds = line.value("seconds", 0.0);
    spent.seconds += seconds;
    spent.core_seconds += line.value("cpu_seconds", seconds);
    if (line.value("event", "") != "finished") continue;
    spent.finished = true;
    spent.steps = line.value("steps", std::int64_t{0});
    spent.bodies = line.value("bodies", std::int64_t{0});
  }
  return spent;
} catch (const std::exception&) {
  return {};
}

}  // namespace jam
