#include "shader_compiler/shader_sources.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/byte_reader.hpp"
#include "base/errors.hpp"
#include "base/text_lines.hpp"
#include "base/text_location.hpp"
#include "shader_compiler/built_in_sources.hpp"

namespace lavaray {
namespace {

// Bounds for files without include guards that include each other. The second is for files that do so twice
// each, whose number doubles with every level.
constexpr std::size_t kMaxIncludeDepth = 32;
constexpr std::size_t kMaxIncludes = 1000;

constexpr std::uintmax_t kMaxFileSize = std::uintmax_t{4} << 20U;

constexpr auto kNone = static_cast<std::size_t>(-1);

// Where messages say that the built-in headers are.
constexpr const char* kBuiltInFolder = "<lavaray>";

}  // namespace

ShaderSources::ShaderSources(std::filesystem::path directory, OnFile onFile, bool offersBuiltIn)
    : directory_(std::move(directory)),
      onFile_(std::move(onFile)),
      offersBuiltIn_(offersBuiltIn),
      openFolders_{directory_} {}

void ShaderSources::add(const std::string& name) {
  const std::filesystem::path file = directory_ / name;
  std::string reason;
  const std::size_t source = read(file, reason);
  if (source != kNone) {
    if (sources_[source].text.find_first_not_of(" \t\r\n") == std::string::npos)
      complaints_.push_back(messageAt({file, 1}, "the file is empty"));
    return;
  }
  if (reason.empty()) reason = std::make_error_code(std::errc::no_such_file_or_directory).message();
  complaints_.push_back(unreadableText(file, reason));
}

std::size_t ShaderSources::include(std::string_view header, std::size_t depth) {
  if (depth > kMaxIncludeDepth || ++includeCount_ > kMaxIncludes) {
    includeFailure_ = "files include each other without end";
    return kNone;
  }
  openFolders_.resize(depth);
  // An include is relative even if it begins with a slash.
  const std::filesystem::path name = std::filesystem::path(header).relative_path();
  for (std::size_t i = depth; i-- > 0;) {
    const std::filesystem::path file = openFolders_[i] / name;
    std::string reason;
    const std::size_t source = openFolders_[i] == kBuiltInFolder ? readBuiltIn(name) : read(file, reason);
    if (source != kNone) {
      openFolders_.push_back(file.parent_path());
      return source;
    }
    if (!reason.empty()) {
      includeFailure_ = file.string() + " cannot be read: " + reason;
      return kNone;
    }
  }
  const std::string folder = directory_.empty() ? "." : directory_.string();
  includeFailure_ = "no such file in " + folder;
  if (!offersBuiltIn_) return kNone;
  includeFailure_ += ", and none of " + builtInSourceNames();
  openFolders_.emplace_back(kBuiltInFolder);
  return readBuiltIn(name);
}

std::size_t ShaderSources::find(const std::filesystem::path& path) const {
  const auto known = std::ranges::find(sources_, path, &ShaderSource::path);
  return known == sources_.end() ? kNone : static_cast<std::size_t>(known - sources_.begin());
}

std::size_t ShaderSources::readBuiltIn(const std::filesystem::path& name) {
  const std::filesystem::path path = kBuiltInFolder / name;
  if (const std::size_t known = find(path); known != kNone) return known;
  const std::optional<std::string_view> text = builtInSource(name.native());
  if (!text) return kNone;
  sources_.push_back({path, std::string(*text)});
  return sources_.size() - 1;
}

std::size_t ShaderSources::read(const std::filesystem::path& file, std::string& reason) {
  if (const std::size_t known = find(file); known != kNone) return known;
  if (std::ranges::find(files_, file) == files_.end()) {
    files_.push_back(file);
    onFile_(file);
  }

  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) return kNone;
  if (error) {
    reason = error.message();
    return kNone;
  }
  // Not a pipe, say, which may never end.
  if (!std::filesystem::is_regular_file(status)) {
    reason = "it is no regular file";
    return kNone;
  }
  if (std::filesystem::file_size(file, error) > kMaxFileSize) {
    reason = error ? error.message() : "it is larger than " + std::to_string(kMaxFileSize) + " bytes";
    return kNone;
  }
  std::string text;
  try {
    text = readFile(file);
    rejectNulBytes(text, file);
  } catch (const std::system_error& systemError) {
    reason = systemError.code().message();
    return kNone;
  } catch (const Error& noText) {
    complaints_.emplace_back(noText.what());
    text.clear();
  }
  sources_.push_back({file, std::move(text)});
  return sources_.size() - 1;
}

}  // namespace lavaray
