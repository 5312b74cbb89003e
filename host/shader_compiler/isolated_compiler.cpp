#include "shader_compiler/isolated_compiler.hpp"

#include <malloc.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "base/huge_pages.hpp"
#include "base/text_location.hpp"

namespace lavaray {
namespace {

// The compiling process sends records: a kind, a size and that many bytes.
enum class Kind : std::uint8_t { kFile, kWarning, kSpirv, kError };

struct Head {
  Kind kind;
  std::uint64_t size;
};

void sendRecord(const IsolatedWork::Send& send, Kind kind, std::string_view bytes) {
  Head head{};
  head.kind = kind;
  head.size = bytes.size();
  send({reinterpret_cast<const char*>(&head), sizeof head});
  send(bytes);
}

// Empty at the end, or where the process ended in the middle of a record.
std::optional<std::pair<Kind, std::string_view>> takeRecord(std::string_view& bytes) {
  Head head{};
  if (bytes.size() < sizeof head) return std::nullopt;
  std::memcpy(&head, bytes.data(), sizeof head);
  bytes.remove_prefix(sizeof head);
  if (bytes.size() < head.size) return std::nullopt;
  const std::string_view content = bytes.substr(0, head.size);
  bytes.remove_prefix(head.size);
  return std::pair{head.kind, content};
}

// A request is one of these characters, followed by the directory or the file.
constexpr char kForFewPrimitives = 'f';
constexpr char kForAnyScene = 'a';
constexpr char kOwn = 'o';

void compileRequested(const std::string& request, const IsolatedWork::Send& send) {
  const char kind = request[0];
  const std::filesystem::path path = request.substr(1);
  const auto sendFile = [&](const std::filesystem::path& file) {
    sendRecord(send, Kind::kFile, file.native());
  };
  try {
    const CompiledShader shader = kind == kOwn
                                      ? compileOwnShader(path, sendFile)
                                      : compileRenderShader(path, kind == kForFewPrimitives, sendFile);
    for (const std::string& warning : shader.warnings) sendRecord(send, Kind::kWarning, warning);
    sendRecord(send, Kind::kSpirv,
               {reinterpret_cast<const char*>(shader.spirv.data()), 4 * shader.spirv.size()});
  } catch (const ShaderError& error) {
    sendRecord(send, Kind::kError, error.what());
  }
}

// A new process has no pages that were used before. A shader takes some 30 MB, whose page faults with small
// pages are a tenth of the time of compiling it. So the heap begins with untouched memory for which huge
// pages are requested; where that is refused, small pages do.
void prepare() {
  prepareCompiler();
  constexpr std::size_t kHeap = std::size_t{48} << 20U;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  void* heap = std::malloc(kHeap);
  if (heap != nullptr) preferHugePages(heap, kHeap);
  std::free(heap);
}

}  // namespace

IsolatedCompiler::IsolatedCompiler() : work_(prepare, compileRequested) {}

CompiledShader IsolatedCompiler::compile(const std::filesystem::path& directory, bool forFewPrimitives) {
  return compile(forFewPrimitives ? kForFewPrimitives : kForAnyScene, directory, directory / "render.comp");
}

CompiledShader IsolatedCompiler::compileOwn(const std::filesystem::path& file) {
  return compile(kOwn, file, file);
}

CompiledShader IsolatedCompiler::compile(char request, const std::filesystem::path& path,
                                         const std::filesystem::path& source) {
  const IsolatedWork::Result result = work_.run(request + path.native());
  CompiledShader shader;
  std::optional<std::string> error;
  std::string_view rest = result.sent;
  while (const auto record = takeRecord(rest)) {
    const auto& [kind, bytes] = *record;
    switch (kind) {
      case Kind::kFile:
        shader.files.emplace_back(bytes);
        break;
      case Kind::kWarning:
        shader.warnings.emplace_back(bytes);
        break;
      case Kind::kSpirv:
        shader.spirv.resize(bytes.size() / 4);
        std::memcpy(shader.spirv.data(), bytes.data(), bytes.size());
        break;
      case Kind::kError:
        error = bytes;
        break;
    }
  }
  if (!result.failure.empty()) {
    if (shader.files.empty()) shader.files.push_back(source);
    error =
        printable(source.native()) + ": the shader compiler ended in the middle of it (" + result.failure +
        "): if there is enough memory, that is a defect of the compiler, and another way to write the last "
        "change may avoid it";
  }
  if (error) throw ShaderError(*error, std::move(shader.files));
  return shader;
}

}  // namespace lavaray
