#include "lavaray/standard_input.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <system_error>

#include "base/byte_reader.hpp"
#include "base/errors.hpp"
#include "base/file_claims.hpp"

namespace lavaray {
namespace {

// A stream that was closed when the program started is open for writing only (program.cpp).
bool isReadable() {
  const int flags = fcntl(STDIN_FILENO, F_GETFL);
  return flags != -1 && (flags & O_ACCMODE) != O_WRONLY;
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
    throw Error(ExitCode::kUsage,
                "SCENE - is standard input, which is a terminal here; pipe a scene into it, or name a file");
  }
  if (!isReadable()) failUnreadable(kStandardInputName, "it is closed, or open for writing only");
  noteRead("/dev/stdin", "the scene");  // which may be a file
  try {
    // The descriptor itself stays open, or a file that is opened later would get its number.
    ByteReader reader(fdopen(dup(STDIN_FILENO), "rb"));
    return readAll(reader);
  } catch (const std::system_error& error) {
    failUnreadable(kStandardInputName, error);
  }
}

}  // namespace lavaray
