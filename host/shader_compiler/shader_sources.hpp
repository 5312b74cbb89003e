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

// The files of one compilation. Each is read once, so that the whole compilation sees the same text.
class ShaderSources {
 public:
  // `onFile` is called for each file when it is looked for.
  using OnFile = std::function<void(const std::filesystem::path&)>;
  // Where `offersBuiltIn`, includes that are no files may be the headers that the program was built with.
  ShaderSources(std::filesystem::path directory, OnFile onFile, bool offersBuiltIn = false);

  // Reads `directory`/`name`; where that fails, the complaints say so. The first source added is the one
  // compiled.
  void add(const std::string& name);

  // The number of the source that `#include "header"` means, or a number past the last source's where there
  // is none; includeFailure() then says why. `depth` is 1 for an include in the first source, 2 for one in a
  // file that this includes, and so on. As glslangValidator does, it looks beside the including file, then
  // beside the file that includes that one, and so on; last in the directory. Built-in headers come after
  // these, but for another built-in header before them.
  std::size_t include(std::string_view header, std::size_t depth);
  [[nodiscard]] const std::string& includeFailure() const { return includeFailure_; }

  [[nodiscard]] const std::deque<ShaderSource>& sources() const { return sources_; }
  // All files that were looked for; none of the built-in headers.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  // What is wrong with the files themselves, one line each; where there is any, a compiler's messages are
  // useless.
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  // The file's number, or a number past the last where there is none; `reason` says why where the file
  // exists.
  std::size_t read(const std::filesystem::path& file, std::string& reason);
  std::size_t readBuiltIn(const std::filesystem::path& name);
  [[nodiscard]] std::size_t find(const std::filesystem::path& path) const;

  std::filesystem::path directory_;
  OnFile onFile_;
  bool offersBuiltIn_;
  std::deque<ShaderSource> sources_;  // a deque, as the compiler holds on to their texts
  std::vector<std::filesystem::path> files_;
  std::vector<std::string> complaints_;
  std::string includeFailure_;
  std::size_t includeCount_ = 0;
  // Of the first source and the includes that are open, outermost first.
  std::vector<std::filesystem::path> openFolders_;
};

}  // namespace lavaray
