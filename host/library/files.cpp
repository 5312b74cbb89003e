#include <lavaray/files.h>

#include <sys/stat.h>
#include <unistd.h>

#include <optional>

#include "base/errors.hpp"
#include "base/file_claims.hpp"
#include "base/output_file.hpp"
#include "base/printable.hpp"
#include "base/temporary_file.hpp"
#include "library/guarded.hpp"

namespace lavaray {
namespace {

OutputName internal(const v0::OutputName& name) {
  return {name.option, name.file, name.mayReplace};
}

}  // namespace

namespace v0 {

struct OutputFile::State {
  explicit State(const OutputName& name) : file(std::in_place, internal(name)) {}
  State(int descriptor, const OutputName& name)
      : shownName(descriptor == STDOUT_FILENO ? "stdout" : printable(name.file.native())) {
    checkNotRead(descriptor, shownName);
    struct stat status {};
    // Keeps other outputs from being the file that the descriptor is open for.
    if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
      claim.emplace(WriteTarget("/proc/self/fd/" + std::to_string(descriptor)), name.file, name.option,
                    std::filesystem::path());
    }
    stream.emplace(descriptor);
  }

  std::optional<lavaray::OutputFile> file;
  std::string shownName;  // these three: of a descriptor
  std::optional<WriteClaim> claim;
  std::optional<CheckedStream> stream;
};

OutputFile::OutputFile(const OutputName& output)
    : state_(guarded([&] { return std::make_unique<State>(output); })) {}
OutputFile::OutputFile(int descriptor, const OutputName& output)
    : state_(guarded([&] { return std::make_unique<State>(descriptor, output); })) {}
OutputFile::~OutputFile() = default;
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;

std::FILE* OutputFile::stream() const {
  return state_->file ? state_->file->stream() : state_->stream->get();
}

void OutputFile::commit() {
  guarded([&] {
    if (state_->file) return state_->file->commit();
    if (const std::string reason = state_->stream->flush(); !reason.empty())
      throw lavaray::Error(ExitCode::kOutput,
                           "the image cannot be written to " + state_->shownName + ": " + reason);
  });
}

void removeTemporaryFiles() noexcept {
  lavaray::removeTemporaryFiles();
}

void protectInputs() noexcept {
  lavaray::protectInputs();
}

void noteRead(const std::filesystem::path& file, const std::string& what) {
  guarded([&] { lavaray::noteRead(file, what); });
}

void checkOutputs(const std::vector<OutputName>& outputs) {
  guarded([&] {
    std::vector<lavaray::OutputName> names;
    for (const OutputName& output : outputs) names.push_back(internal(output));
    lavaray::checkOutputs(names);
  });
}

}  // namespace v0
}  // namespace lavaray
