#include "library/device_state.hpp"

#include <mutex>
#include <utility>

#include "base/errors.hpp"
#include "library/guarded.hpp"
#include "vulkan/driver_survey.hpp"

namespace lavaray {
namespace {

// Of the instance: the functions of the Vulkan loader are fetched for one at a time, and so it is made and
// closed by one thread at a time.
std::mutex instanceMutex;
std::weak_ptr<vulkan::Instance> openInstance;

void close(vulkan::Instance* instance) {
  const std::lock_guard lock(instanceMutex);
  delete instance;
}

v0::DeviceInfo publicInfo(const vulkan::DeviceDescription& device) {
  return {device.name, device.kind, device.driver, device.usable, device.isCpu};
}

TuningChoice checkedChoice(const std::string& way) {
  const std::optional<TuningChoice> choice = tuningChoice(way);
  if (choice) return *choice;
  throw Error(ExitCode::kUsage, "there is no tuning " + way + ", allowed are " + v0::kTuningWays);
}

}  // namespace

std::shared_ptr<vulkan::Instance> sharedInstance(vulkan::OnMessage onMessage) {
  const std::lock_guard lock(instanceMutex);
  std::shared_ptr<vulkan::Instance> instance = openInstance.lock();
  if (!instance) {
    instance = {new vulkan::Instance(std::move(onMessage)), close};
    openInstance = instance;
  } else if (instance->isValidated() || onMessage) {
    throw Error(ExitCode::kUsage, "a device under the validation layer is the only one that can be open");
  }
  return instance;
}

namespace v0 {

Device::Device(const std::string& choice, std::function<void(const std::string&)> onMessage,
               const TuningOptions& tuning)
    : state_(guarded([&] {
        const TuningChoice way = checkedChoice(tuning.way);
        auto state = std::make_shared<State>();
        state->opening = std::async(std::launch::async, [choice, onMessage, way, folder = tuning.folder] {
          return std::make_shared<OpenDevice>(choice, onMessage, way, folder);
        });
        return state;
      })) {}
Device::~Device() = default;
Device::Device(const Device&) = default;
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(const Device&) = default;
Device& Device::operator=(Device&&) noexcept = default;

DeviceInfo Device::info() const {
  return guarded([&] { return publicInfo(state_->open().device.description()); });
}

std::vector<std::string> Device::warnings() const {
  return guarded([&] { return state_->open().instance->warnings(); });
}

std::string Device::tuning() const {
  return guarded([&] { return state_->open().tuning.description(); });
}

bool isTuningWay(const std::string& way) {
  return tuningChoice(way).has_value();
}

DeviceList listDevices() {
  return guarded([] {
    const std::shared_ptr<vulkan::Instance> instance = sharedInstance({});
    DeviceList list{{}, instance->warnings()};
    for (const auto& device : vulkan::listDevices(*instance)) list.devices.push_back(publicInfo(device));
    return list;
  });
}

std::vector<std::string> describeDrivers() {
  return guarded([] { return vulkan::surveyDrivers().lines(true); });
}

}  // namespace v0
}  // namespace lavaray
