#include "vulkan/manifest_file.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <system_error>

#include "vulkan/driver_search.hpp"

namespace lavaray::vulkan {
namespace {

using Json = nlohmann::json;

// Real ones have less than a kilobyte; a megabyte still takes no time to read.
constexpr std::uintmax_t kMaxBytes = 1U << 20U;

std::optional<std::string> readText(const std::string& file, std::string& problem) {
  std::error_code isNone;
  if (std::filesystem::is_directory(file, isNone)) {
    problem = ", which is a folder";
    return std::nullopt;
  }
  // A pipe or a device may have no end.
  std::error_code hasNoSize;
  const std::uintmax_t size = std::filesystem::file_size(file, hasNoSize);
  if (std::filesystem::exists(file, isNone) && !std::filesystem::is_regular_file(file, isNone)) {
    problem = ", which is no regular file";
    return std::nullopt;
  }
  if (!hasNoSize && size > kMaxBytes) {
    problem = ", which is too large for a manifest";
    return std::nullopt;
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in.is_open()) {
    problem = ", which cannot be read: " + std::generic_category().message(errno);
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// Where and how a text fails to be JSON; `offset` is the number of characters up to and including the wrong
// one.
std::string syntaxProblem(const std::string& text, std::size_t offset) {
  std::string until = text.substr(0, offset == 0 ? 0 : offset - 1);
  const bool isCutOff = offset > text.size();
  if (isCutOff) until.resize(until.find_last_not_of(" \t\r\n") + 1);
  const std::string line = "line " + std::to_string(1 + std::count(until.begin(), until.end(), '\n'));
  if (isCutOff) return ", which is no manifest: it is cut off in " + line;
  const std::size_t before = until.find_last_not_of(" \t\r\n");
  const char unexpected = text[until.size()];
  if (before != std::string::npos && until[before] == ',' && (unexpected == '}' || unexpected == ']')) {
    return ", which is no manifest: a comma too many before the bracket in " + line;
  }
  return ", which is no manifest: " + line + " is no JSON";
}

Json parse(const std::string& text, bool acceptsMark, ManifestContents& contents) {
  if (text.empty()) {
    contents.problem = ", which is empty";
    return {};
  }
  contents.isUnparsable = true;
  if (text.starts_with("\xEF\xBB\xBF") && !acceptsMark) {
    contents.problem = ", which begins with a UTF-8 byte-order mark: this Vulkan loader cannot read it";
    return {};
  }
  Json json;
  try {
    std::istringstream(text) >> json;  // like the loader, ignores what follows the object
    contents.isUnparsable = false;
  } catch (const Json::parse_error& error) {
    contents.problem = syntaxProblem(text, error.byte);
  } catch (const Json::exception&) {
    contents.problem = ", which is no manifest: it is no JSON";
  }
  return json;
}

std::string pathOf(const std::string& library, const std::string& file) {
  if (library.find('/') == std::string::npos || library.starts_with('/')) return library;
  // Absolute, as the system would search its own folders for a name without a slash.
  return std::filesystem::absolute(std::filesystem::path(file).parent_path() / library).lexically_normal();
}

// Why the loader passes the driver over, if it does; and where its library is.
std::string readDriver(const Json& json, const std::string& file, std::string& library) {
  if (!json.is_object() || !json.contains("ICD") || !json["ICD"].is_object()) {
    return json.is_object() && (json.contains("layer") || json.contains("layers"))
               ? ", which is the manifest of a layer, not of a driver"
               : R"(, which is no manifest of a driver: it has no "ICD")";
  }
  const Json& icd = json["ICD"];
  const auto text = [&](const char* key) {
    return icd.contains(key) && icd[key].is_string() ? icd[key].get<std::string>() : std::string();
  };
  library = pathOf(text("library_path"), file);
  if (!json.contains("file_format_version")) return R"(, whose "file_format_version" is missing)";
  if (library.empty()) return R"(, whose "library_path" is missing or empty, so that it names no driver)";
  if (text("api_version").empty()) return R"(, whose "api_version" is missing)";
  if (icd.value("is_portability_driver", Json()) == Json(true)) {
    return R"(, whose driver lacks parts of Vulkan, as its "is_portability_driver" says)";
  }
  const std::string bits = sizeof(void*) == 8 ? "64" : "32";
  if (const std::string arch = text("library_arch"); (arch == "32" || arch == "64") && arch != bits) {
    return ", whose driver is for programs of " + arch + " bits, and this one has " + bits;
  }
  return {};
}

}  // namespace

ManifestContents readDriverManifest(const std::string& file, bool acceptsMark) {
  ManifestContents contents;
  const std::optional<std::string> text = readText(file, contents.problem);
  if (!text) return contents;
  const Json json = parse(*text, acceptsMark, contents);
  if (contents.problem.empty()) contents.problem = readDriver(json, file, contents.library);
  return contents;
}

ManifestContents readLayerManifest(const std::string& file, bool acceptsMark) {
  ManifestContents contents;
  if (const std::optional<std::string> text = readText(file, contents.problem)) {
    parse(*text, acceptsMark, contents);
  }
  return contents;
}

}  // namespace lavaray::vulkan
