#include "lavaray/standard_input.hpp"

#include <fcntl.h>
#include <lavaray/files.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace lavaray {
namespace {

// A stream that was closed when the program started is open for writing only (program.cpp).
bool isReadable() {
  const int flags = fcntl(STDIN_FILENO, F_GETFL);
  return flags != -1 && (flags & O_ACCMODE) != O_WRONLY;
}

[[noreturn]] void failUnreadable(const std::string& reason) {
  const std::string name = kStandardInputName;
  throw Error(ErrorKind::kInput, name + ": cannot be read: " + reason, name);
}

}  // namespace

bool isStandardInput(const std::filesystem::path& scene) {
  return scene == "-";
}

std::string shownName(const std::filesystem::path& scene) {
  return isStandardInput(scene) ? kStandardInputName : scene.string();
}

std::string readStandardInput() {
  if (isatty(STDIN_FILENO) == 1) {
    throw Error(ErrorKind::kUsage,
                "SCENE - is standard input, which is a terminal here; pipe a scene into it, or name a file");
  }
  if (!isReadable()) failUnreadable("it is closed, or open for writing only");
  noteRead("/dev/stdin", "the scene");  // which may be a file
  std::string text;
  std::array<char, 1U << 16U> chunk;
  for (;;) {
    const ssize_t count = read(STDIN_FILENO, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failUnreadable(std::generic_category().message(errno));
    if (count == 0) return text;
    text.append(chunk.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace lavaray
