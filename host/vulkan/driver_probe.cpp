#include "vulkan/driver_probe.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include "vulkan/driver_library.hpp"
#include "vulkan/driver_search.hpp"
#include "vulkan/loader.hpp"
#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

using Clock = std::chrono::steady_clock;

// Far longer than any driver takes, even that of a GPU that has to wake up.
constexpr auto kPatience = std::chrono::seconds(20);

// How loader and driver agree on the version of their interface (vulkan/vk_icd.h).
using Negotiate = VkResult(VKAPI_PTR*)(std::uint32_t* version);
constexpr std::uint32_t kInterfaceVersion = 5;

const char* meaning(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "that it gets no memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "that the device has no memory left";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "that its start failed, and not why";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "that it does not fit the program or the hardware";
    default:
      return "that it failed, and not why";
  }
}

std::string reason(VkResult result) {
  return std::string(meaning(result)) + " (" + resultName(result) + ')';
}

DriverAnswer faulty(const std::string& text, const std::string& library) {
  return {DriverState::kFaulty, text + missingForNvidia(library)};
}

// The driver's function of that name, through the loader's interface; null if it has none.
template <typename Function>
Function function(PFN_vkGetInstanceProcAddr get, VkInstance instance, const char* name) {
  return reinterpret_cast<Function>(get(instance, name));
}

PFN_vkGetInstanceProcAddr entryPoint(void* handle) {
  for (const char* name : {"vk_icdGetInstanceProcAddr", "vkGetInstanceProcAddr"}) {
    if (void* symbol = dlsym(handle, name)) return reinterpret_cast<PFN_vkGetInstanceProcAddr>(symbol);
  }
  return nullptr;
}

bool agrees(void* handle, PFN_vkGetInstanceProcAddr get) {
  constexpr const char* kName = "vk_icdNegotiateLoaderICDInterfaceVersion";
  auto negotiate = reinterpret_cast<Negotiate>(dlsym(handle, kName));
  if (negotiate == nullptr) negotiate = function<Negotiate>(get, VK_NULL_HANDLE, kName);
  std::uint32_t version = kInterfaceVersion;
  return negotiate == nullptr || negotiate(&version) == VK_SUCCESS;
}

VkResult createInstance(PFN_vkGetInstanceProcAddr get, PFN_vkCreateInstance create, VkInstance& instance) {
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "lavaray";
  // A driver of Vulkan 1.0 refuses any other version; the loader hides that.
  const bool isFirst =
      function<PFN_vkVoidFunction>(get, VK_NULL_HANDLE, "vkEnumerateInstanceVersion") == nullptr;
  application.apiVersion = isFirst ? VK_API_VERSION_1_0 : VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  return create(&info, nullptr, &instance);
}

// Runs in the child, which ends afterwards, so nothing needs destroying.
DriverAnswer ask(const std::string& library) {
  std::string problem;
  void* handle = openDriverLibrary(library, problem);
  if (handle == nullptr) return faulty(problem, library);
  const std::string driver = ", whose driver " + inQuotes(library);
  const PFN_vkGetInstanceProcAddr get = entryPoint(handle);
  const std::string noDriver =
      ", whose library " + inQuotes(library) + " has no entry point for Vulkan: it is no driver";
  if (get == nullptr) return faulty(noDriver, library);
  if (!agrees(handle, get)) return faulty(driver + " does not come to terms with the Vulkan loader", library);
  const auto create = function<PFN_vkCreateInstance>(get, VK_NULL_HANDLE, "vkCreateInstance");
  if (create == nullptr) return faulty(noDriver, library);
  VkInstance instance = VK_NULL_HANDLE;
  VkResult result = createInstance(get, create, instance);
  if (result != VK_SUCCESS) return faulty(driver + " does not start: it says " + reason(result), library);
  const auto enumerate =
      function<PFN_vkEnumeratePhysicalDevices>(get, instance, "vkEnumeratePhysicalDevices");
  std::uint32_t count = 0;
  result = enumerate != nullptr ? enumerate(instance, &count, nullptr) : VK_ERROR_UNKNOWN;
  if (result != VK_SUCCESS) {
    return faulty(driver + " cannot list its devices: it says " + reason(result), library);
  }
  if (count == 0) return {DriverState::kNoDevice, driver + " has no device" + missingForNvidia(library)};
  return {DriverState::kWorks,
          driver + " has " + (count == 1 ? "a device" : std::to_string(count) + " devices")};
}

[[noreturn]] void answerAndEnd(const std::string& library, int out) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);  // under nohup
  }
  if (const int null = open("/dev/null", O_RDWR); null >= 0) {
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
  }
  int code = 1;
  try {
    const DriverAnswer answer = ask(library);
    const std::string line = std::to_string(static_cast<int>(answer.state)) + answer.text;
    code = write(out, line.data(), line.size()) == static_cast<ssize_t>(line.size()) ? 0 : 1;
  } catch (const std::exception&) {  // no memory; the parent notices the silence
  }
  _exit(code);
}

// Reads all that the child says until it ends. False if that takes too long.
bool readAll(int in, std::string& text) {
  const Clock::time_point end = Clock::now() + kPatience;
  char buffer[512];
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd waiting{in, POLLIN, 0};
    const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t size = read(in, buffer, sizeof buffer);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(size));
  }
}

}  // namespace

DriverAnswer probeDriver(const std::string& library) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
  // There may be other threads. After fork(), glibc's own locks are free in the child, malloc's and dlopen's
  // among them, and the child needs no other lock that a thread may have held.
  const pid_t child = fork();
  if (child < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    if (error == ENOMEM) throw std::bad_alloc();
    throw std::system_error(error, std::generic_category());
  }
  if (child == 0) answerAndEnd(library, ends[1]);
  close(ends[1]);
  std::string said;
  const bool isInTime = readAll(ends[0], said);
  close(ends[0]);
  if (!isInTime) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const std::string driver = ", whose driver " + inQuotes(library);
  if (!isInTime) return {DriverState::kFaulty, driver + " does not answer within 20 seconds"};
  if (WIFSIGNALED(status)) {
    return {DriverState::kFaulty, driver + " ends the program that loads it: " + strsignal(WTERMSIG(status))};
  }
  if (said.empty() || said[0] < '0' || said[0] > '3') {
    return {DriverState::kFaulty, driver + " gives no answer; is there memory for it?"};
  }
  return {static_cast<DriverState>(said[0] - '0'), said.substr(1)};
}

}  // namespace lavaray::vulkan
