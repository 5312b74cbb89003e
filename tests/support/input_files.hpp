#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <gtest/gtest.h>

#include "base/errors.hpp"

namespace lavaray {

// A folder of this process alone, as tests may run at the same time; removed at its end.
class ProcessFolder {
 public:
  ProcessFolder()
      : path_(std::filesystem::path(testing::TempDir()) / ("lavaray." + std::to_string(getpid()))) {}
  ~ProcessFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ProcessFolder(const ProcessFolder&) = delete;
  ProcessFolder& operator=(const ProcessFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// A folder of the running test alone.
inline std::filesystem::path testFolder() {
  static const ProcessFolder processFolder;
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::ranges::replace(name, '/', '_');
  const auto folder = processFolder.path() / name;
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::filesystem::path writeFile(const std::string& name, std::string_view content) {
  const auto file = testFolder() / name;
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

// The message of the input error that `read` throws; empty where it throws none.
template <typename Read>
std::string inputError(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), ExitCode::kInput);
    return error.what();
  }
  return {};
}

// The message is `file:line: ...` and contains `words`.
inline void expectMessage(const std::string& message, const std::filesystem::path& file, std::size_t line,
                          std::string_view words) {
  const std::string start = file.string() + ":" + std::to_string(line) + ": ";
  EXPECT_TRUE(message.starts_with(start)) << message << "\nshould start with " << start;
  EXPECT_NE(message.find(words), std::string::npos) << message << "\nshould contain " << words;
}

}  // namespace lavaray
