#include "vulkan/loader_environment.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <memory>

#include "vulkan/driver_search.hpp"

namespace lavaray::vulkan {
namespace {

// A base folder that can hold nothing. It stands for none, since an empty variable means the usual folders.
constexpr const char* kNoFolder = "/dev/null";

using Variables = std::map<std::string, std::string>;

void append(std::string& list, const std::string& file) {
  if (file.find(':') != std::string::npos) return;  // which no list can name
  list += (list.empty() ? "" : ":") + file;
}

std::string soundDrivers(const DriverSurvey& survey) {
  std::string list;
  for (const SurveyedDriver& driver : survey.drivers) {
    if (driver.state == DriverState::kWorks) append(list, driver.file);
  }
  return list;
}

std::string soundLayers(const std::vector<SurveyedLayer>& layers) {
  std::string list;
  for (const SurveyedLayer& layer : layers) {
    if (!layer.isBroken) append(list, layer.file);
  }
  return list;
}

// Implicit layers are found through base folders only, so a folder with a broken one is left out whole.
bool hasBrokenLayer(const std::string& base, const std::vector<SurveyedLayer>& layers) {
  const auto folder = std::filesystem::path(base) / "vulkan" / "implicit_layer.d";
  return std::any_of(layers.begin(), layers.end(), [&](const SurveyedLayer& layer) {
    return layer.isBroken && std::filesystem::path(layer.file).parent_path() == folder;
  });
}

Variables soundVariables(const DriverSurvey& survey) {
  Variables variables;
  variables["VK_DRIVER_FILES"] = variables["VK_ICD_FILENAMES"] = soundDrivers(survey);
  variables["VK_LAYER_PATH"] = soundLayers(survey.explicitLayers);
  for (const BaseFolders& base : manifestBaseFolders()) {
    if (base.variable == nullptr) continue;
    std::string list;
    for (const std::string& folder : base.folders) {
      if (!hasBrokenLayer(folder, survey.implicitLayers)) append(list, folder);
    }
    variables[base.variable] = list.empty() ? kNoFolder : list;
  }
  return variables;
}

struct Table {
  std::vector<std::string> strings;
  std::vector<char*> pointers;
};

// Kept until the process ends: someone may still be reading it.
char** makeTable(const Variables& changed) {
  static auto& tables = *new std::vector<std::unique_ptr<Table>>;
  Table& table = *tables.emplace_back(std::make_unique<Table>());
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!changed.contains(text.substr(0, text.find('=')))) table.strings.push_back(text);
  }
  for (const auto& [name, value] : changed) table.strings.push_back(name + "=" + value);
  for (std::string& text : table.strings) table.pointers.push_back(text.data());
  table.pointers.push_back(nullptr);
  return table.pointers.data();
}

void use(char** table) {
  std::atomic_ref(environ).store(table);
}

}  // namespace

LoaderEnvironment::LoaderEnvironment(const DriverSurvey& survey) : before_(environ) {
  use(makeTable(soundVariables(survey)));
}

LoaderEnvironment::~LoaderEnvironment() {
  use(before_);
}

}  // namespace lavaray::vulkan
