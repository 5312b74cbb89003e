#include "vulkan/driver_library.hpp"

#include <dlfcn.h>
#include <elf.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "vulkan/driver_search.hpp"

namespace lavaray::vulkan {
namespace {

using ElfHeader = std::array<char, 20>;  // up to e_machine: what 32 and 64 bits have in common

bool readHeader(const std::string& file, ElfHeader& header) {
  std::ifstream in(file, std::ios::binary);
  return static_cast<bool>(in.read(header.data(), static_cast<std::streamsize>(header.size())));
}

bool isElf(const ElfHeader& header) {
  return std::memcmp(header.data(), ELFMAG, SELFMAG) == 0;
}

std::string machineName(const ElfHeader& header) {
  std::uint16_t machine = 0;
  std::memcpy(&machine, header.data() + 18, sizeof machine);
  switch (machine) {
    case EM_386:
    case EM_X86_64:
      return "x86";
    case EM_ARM:
    case EM_AARCH64:
      return "ARM";
    case EM_RISCV:
      return "RISC-V";
    case EM_PPC64:
      return "POWER";
    case EM_S390:
      return "S/390";
    default:
      return "another one";
  }
}

// Of a library for another machine the system itself says that there is no such file.
std::string problemOfFile(const std::string& library) {
  std::error_code error;
  if (!std::filesystem::exists(library, error)) return " is not there";
  ElfHeader header{};
  ElfHeader own{};
  if (!readHeader(library, header)) {
    std::ifstream in(library, std::ios::binary);
    return in.is_open() ? " is no library" : " cannot be read";
  }
  if (!isElf(header)) return " is no library";
  if (!readHeader("/proc/self/exe", own)) return {};
  const auto bits = [](const ElfHeader& of) { return of[EI_CLASS] == ELFCLASS32 ? "32" : "64"; };
  if (header[EI_CLASS] != own[EI_CLASS]) {
    return std::string(" is for programs of ") + bits(header) + " bits, and this one has " + bits(own);
  }
  if (header[EI_DATA] != own[EI_DATA] || std::memcmp(header.data() + 18, own.data() + 18, 2) != 0) {
    return " is for another machine: " + machineName(header) + " of " + bits(header) + " bits";
  }
  return {};
}

// What glibc's dlerror() says of a missing file, after its name.
constexpr const char* kMissing = ": cannot open shared object file: No such file or directory";

std::string problemOfLoading(const std::string& library, const std::string& reason) {
  if (!reason.ends_with(kMissing)) return " cannot be loaded: " + inQuotes(reason);
  const std::string file = reason.substr(0, reason.size() - std::strlen(kMissing));
  if (file == library) return " is in none of the folders where this system looks for libraries";
  return " needs " + inQuotes(file) + ", which is not there; install it";
}

}  // namespace

void* openDriverLibrary(const std::string& library, std::string& problem) {
  const bool isPath = library.find('/') != std::string::npos;
  std::string what = isPath ? problemOfFile(library) : std::string();
  if (what.empty()) {
    if (void* handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL)) return handle;
    const char* reason = dlerror();
    what = problemOfLoading(library, reason != nullptr ? reason : "no reason is given");
  }
  problem = ", whose library " + inQuotes(library) + what;
  return nullptr;
}

std::string missingForNvidia(const std::string& library) {
  if (library.find("nvidia") == std::string::npos) return {};
  constexpr std::pair<const char*, const char*> kNeeded[] = {{"libX11.so.6", "libx11-6"},
                                                             {"libXext.so.6", "libxext6"},
                                                             {"libGL.so.1", "libgl1"},
                                                             {"libEGL.so.1", "libegl1"},
                                                             {"libGLdispatch.so.0", "libglvnd0"}};
  std::string files;
  std::string packages;
  for (const auto& [file, package] : kNeeded) {
    if (dlopen(file, RTLD_LAZY | RTLD_LOCAL) != nullptr) continue;
    files += (files.empty() ? "" : ", ") + inQuotes(file);
    packages += std::string(" ") + package;
  }
  if (files.empty()) return {};
  return "; NVIDIA's driver needs " + files + " of this system, which cannot be loaded: install" + packages;
}

}  // namespace lavaray::vulkan
