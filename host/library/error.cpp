#include <lavaray/error.h>

#include <new>
#include <system_error>
#include <utility>

#include "base/errors.hpp"
#include "library/guarded.hpp"
#include "library/version.hpp"

namespace lavaray {
namespace {

constexpr const char* kNoMemory = "there is not enough memory; a smaller image or scene needs less";

static_assert(static_cast<int>(v0::ErrorKind::kMemory) == static_cast<int>(ExitCode::kMemory));

v0::Error publicError(const std::system_error& error) {
  // If a thread cannot start, the system says no more than to try again.
  const bool isMemory = error.code() == std::errc::not_enough_memory ||
                        error.code() == std::errc::resource_unavailable_try_again;
  if (isMemory) return {v0::ErrorKind::kMemory, kNoMemory};
  return {v0::ErrorKind::kInternal, "the system refuses what is needed: " + error.code().message()};
}

}  // namespace

void throwPublicError() {
  try {
    throw;
  } catch (const v0::Error&) {
    throw;
  } catch (const Error& error) {
    throw v0::Error(static_cast<v0::ErrorKind>(error.exitCode()), error.what(), error.file(), error.line());
  } catch (const std::bad_alloc&) {
    throw v0::Error(v0::ErrorKind::kMemory, kNoMemory);
  } catch (const std::system_error& error) {
    throw publicError(error);
  } catch (const std::exception& error) {
    throw v0::Error(v0::ErrorKind::kInternal,
                    std::string("internal error, a defect of the program: ") + error.what());
  }
}

namespace v0 {

Error::Error(ErrorKind kind, const std::string& message, std::string file, std::size_t line)
    : std::runtime_error(message), kind_(kind), file_(std::move(file)), line_(line) {}

Error::Error(const Error&) = default;

Error::~Error() = default;

const char* version() noexcept {
  return kVersion;
}

}  // namespace v0
}  // namespace lavaray
