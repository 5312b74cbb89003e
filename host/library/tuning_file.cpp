#include "library/tuning_file.hpp"

#include <unistd.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>
#include <system_error>

#include "base/output_file.hpp"
#include "library/version.hpp"

namespace lavaray {
namespace {

namespace fs = std::filesystem;

// What the times depend on: the first line of the file.
std::string identity(const vulkan::DeviceDescription& device) {
  return "lavaray " + std::string(kVersion) + ", " + device.name + ", " + device.driver;
}

fs::path tuningFile(const fs::path& folder, const vulkan::DeviceDescription& device) {
  std::string name = "tuning";
  for (const char c : device.name + ' ' + device.driver) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += c;
    } else if (name.back() != '-') {
      name += '-';
    }
  }
  return folder / (name + ".txt");
}

std::optional<TuningTime> readTime(const std::string& line) {
  std::istringstream words(line);
  words.imbue(std::locale::classic());
  std::string name;
  double seconds = 0.0;
  if (!(words >> name >> seconds) || !(seconds > 0.0) || !std::isfinite(seconds)) return std::nullopt;
  const std::optional<Tuning> tuning = tuningNamed(name);
  if (!tuning) return std::nullopt;
  return TuningTime{*tuning, seconds};
}

}  // namespace

std::string sceneReadAs(bool inStorage) {
  return inStorage ? "storage" : "texels";
}

std::string tuningName(const Tuning& tuning) {
  return sceneReadAs(tuning.sceneInStorage) + ',' + std::to_string(tuning.raysPerLane);
}

std::optional<Tuning> tuningNamed(const std::string& name) {
  for (const bool inStorage : {false, true}) {
    for (const std::uint32_t rays : {1U, 2U, 4U}) {
      const Tuning tuning{inStorage, rays};
      if (tuningName(tuning) == name) return tuning;
    }
  }
  return std::nullopt;
}

bool canKeepTunings(const fs::path& folder) {
  if (folder.empty()) return false;
  std::error_code ignored;  // then it cannot be written to
  fs::create_directories(folder, ignored);
  return access(folder.c_str(), W_OK | X_OK) == 0;
}

std::vector<TuningTime> readTuningFile(const fs::path& folder, const vulkan::DeviceDescription& device) {
  if (folder.empty()) return {};
  std::ifstream file(tuningFile(folder, device));
  std::string line;
  if (!std::getline(file, line) || line != identity(device)) return {};
  std::vector<TuningTime> times;
  while (std::getline(file, line)) {
    const std::optional<TuningTime> time = readTime(line);
    if (!time) return {};
    times.push_back(*time);
  }
  return times;
}

void writeTuningFile(const fs::path& folder, const vulkan::DeviceDescription& device,
                     std::span<const TuningTime> times) {
  (void)canKeepTunings(folder);  // if not, the file tells
  OutputFile file({.option = "the tuning", .file = tuningFile(folder, device)});
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << identity(device) << '\n';
  for (const TuningTime& time : times) text << tuningName(time.tuning) << ' ' << time.seconds << '\n';
  std::fputs(text.str().c_str(), file.stream());
  file.commit();
}

}  // namespace lavaray
