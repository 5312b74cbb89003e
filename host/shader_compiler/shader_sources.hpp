#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lavaray {

struct ShaderSource {
  std::filesystem::path path;
  std::string text;  // empty where the file is no text
};

// The files of one compilation, each read once, so that all of the compilation sees the same text.
class ShaderSources {
 public:
  // `onFile` is told of each file when it is looked for.
  using OnFile = std::function<void(const std::filesystem::path&)>;
  ShaderSources(std::filesystem::path directory, OnFile onFile);

  // Reads `directory`/`name`; the complaints say so where that cannot be done. The first is the file that is
  // compiled.
  void add(const std::string& name);

  // The number of the source that `#include "header"` means, or a number past the last source's where there
  // is none; includeFailure() then says why. `depth` is 1 for an include of the first source, 2 for one of
  // such an include's, and so on. Looks beside the including file, then beside the one that includes that,
  // and last in the directory, as glslangValidator does.
  std::size_t include(std::string_view header, std::size_t depth);
  [[nodiscard]] const std::string& includeFailure() const { return includeFailure_; }

  [[nodiscard]] const std::deque<ShaderSource>& sources() const { return sources_; }
  // Everything that was looked for.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  // What is wrong with the files themselves, a line each; whatever a compiler says is of no use then.
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  // Its number, or a number past the last where there is no such file, with the reason where it is there.
  std::size_t read(const std::filesystem::path& file, std::string& reason);

  std::filesystem::path directory_;
  OnFile onFile_;
  std::deque<ShaderSource> sources_;  // a deque, as the compiler holds on to their texts
  std::vector<std::filesystem::path> files_;
  std::vector<std::string> complaints_;
  std::string includeFailure_;
  std::size_t includeCount_ = 0;
  // Of the first source and the includes that are open in it, outermost first.
  std::vector<std::filesystem::path> openFolders_;
};

}  // namespace lavaray
