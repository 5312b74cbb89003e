#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "shader_compiler/shader_compiler.hpp"
#include "support/input_files.hpp"

namespace lavaray {

// A copy of the project's shaders for the running test to edit.
class ShaderFolder {
 public:
  explicit ShaderFolder(const std::string& name = "shaders") : path_(testFolder() / name) {
    std::filesystem::remove_all(path_);
    std::filesystem::copy(LAVARAY_SHADERS_DIR, path_, std::filesystem::copy_options::recursive);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  [[nodiscard]] std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path_ / name, std::ios::binary).rdbuf();
    return text.str();
  }
  void write(const std::string& name, std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  // Puts `to` where `from` stands first. Returns `PATH:LINE: ` of that place, in which a message about it
  // begins.
  [[nodiscard]] std::string replace(const std::string& name, std::string_view from,
                                    std::string_view to) const {
    std::string text = read(name);
    const std::size_t at = text.find(from);
    if (at == std::string::npos) {
      ADD_FAILURE() << name << " has no " << from;
      return {};
    }
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    write(name, text.replace(at, from.size(), to));
    return (path_ / name).string() + ":" + std::to_string(line) + ": ";
  }

  // The message of the compilation's error; empty where it has none.
  [[nodiscard]] std::string error() const {
    return inputError([&] { compileRenderShader(path_, false); });
  }

 private:
  std::filesystem::path path_;
};

}  // namespace lavaray
