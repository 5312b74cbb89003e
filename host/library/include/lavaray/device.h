#ifndef LAVARAY_DEVICE_H
#define LAVARAY_DEVICE_H

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <lavaray/scene.h>

// Vulkan devices. What the Vulkan loader and drivers read of the environment is theirs to document.
namespace lavaray::v0 {

struct DeviceInfo {
  std::string name;
  std::string kind;    // discrete GPU, integrated GPU, virtual GPU, CPU, other
  std::string driver;  // name and version
  bool isUsable;       // it has Vulkan 1.2 and a compute queue
  bool isCpu;
};

struct DeviceList {
  std::vector<DeviceInfo> devices;    // in the driver's order, which numbers them
  std::vector<std::string> warnings;  // of drivers that are broken and left out
};

// Throws Error(kDevice), saying why, if there is none.
LAVARAY_API DeviceList listDevices();

// What there is to know of each driver's manifest, a line each. Starts each driver in a process of its own.
LAVARAY_API std::vector<std::string> describeDrivers();

// How renders on a device trace. No way changes a bit of a picture.
struct TuningOptions {
  // How a scene that is searched is read: texels or storage; and how many rays an invocation traces together
  // at most: texels,1 for example. `auto` takes what was measured on the device before, and measures before a
  // long render where nothing was and it can be kept; `measure` does so now, which takes some seconds.
  std::string way = "auto";
  // Where what was measured on devices is kept; made where it is missing. Empty: it is not kept.
  std::filesystem::path folder;
};
inline constexpr const char* kTuningWays =
    "auto, measure, texels or storage, the latter two with ,1 ,2 or ,4 as well";
LAVARAY_API bool isTuningWay(const std::string& way);

// A device with the pipelines that renders on it have made. Copies stand for the same device, which closes
// with the last of them. Several threads may render on one device at the same time.
class LAVARAY_API Device {
 public:
  // By number or by part of the name, ignoring case; without a choice, the best usable device: discrete,
  // integrated, CPU. It is opened in a thread of its own while other work goes on. What needs the device
  // waits for it, and throws Error(kDevice), saying why, if it cannot be opened. With `onMessage` it runs
  // under the Khronos validation layer, whose complaints that gets, from any thread; a process has one such
  // device at a time, and no other beside it. Throws Error(kUsage) if there is no such way to trace.
  explicit Device(const std::string& choice = {}, std::function<void(const std::string&)> onMessage = {},
                  const TuningOptions& tuning = {});
  ~Device();
  Device(const Device&);
  Device(Device&&) noexcept;
  Device& operator=(const Device&);
  Device& operator=(Device&&) noexcept;

  // These wait.
  DeviceInfo info() const;
  std::vector<std::string> warnings() const;  // of drivers that are broken and left out
  std::string tuning() const;                 // the way that is taken now, and why, in words

  struct State;
  State& state() const { return *state_; }  // for the library's own use

 private:
  std::shared_ptr<State> state_;
};

// SPIR-V of the render shader, for one kind of scene: of few triangles and spheres, or of more.
struct CompiledShader {
  std::vector<std::uint32_t> spirv;
};

// Compiles a changed copy of the render shader, whose sources are installed in share/lavaray/shaders. It
// starts a process for that, by fork(): it has to be made by the main thread, before there are others, of a
// Device, too.
class LAVARAY_API ShaderCompiler {
 public:
  using Files = std::vector<std::filesystem::path>;

  explicit ShaderCompiler(const std::filesystem::path& folder);
  ~ShaderCompiler();
  ShaderCompiler(ShaderCompiler&&) noexcept;
  ShaderCompiler& operator=(ShaderCompiler&&) noexcept;

  // Compiles it for scenes of that kind, unless that is done already and none of its files is among those
  // that have changed. Returns whether it did. Throws Error(kInput), a line `file:line: message` for each
  // fault; the shader that it had before for that kind of scene stays.
  bool compile(const Scene& scene, const Files& changed = {});

  // These are of the kind of scene that was compiled for last. Null if there is none yet.
  std::shared_ptr<const CompiledShader> shader() const;
  const Files& files() const;  // as last read or tried to be read
  std::vector<std::string> takeWarnings();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// A compute shader of the user's own, in GLSL, for Renderer::run: it runs for each pixel of a picture, over
// the scene's arrays and its hierarchy. docs/shaders.md says how to write one. It is compiled in another
// process, which is started by fork(): best before there are threads, whose locks that process would wait for
// in vain.
class LAVARAY_API Shader {
 public:
  using Files = std::vector<std::filesystem::path>;

  // Throws Error(kInput), a line `file:line: message` for each fault; the error's file and line are the
  // first's.
  explicit Shader(const std::filesystem::path& file);
  ~Shader();
  Shader(Shader&&) noexcept;
  Shader& operator=(Shader&&) noexcept;

  // Compiles it anew if one of files() has changed since. Returns whether it did. If it throws Error(kInput),
  // the shader stays as it was, and there is nothing to be done until the next change.
  bool reload();

  const Files& files() const;  // it and its includes, as last read or tried to be read
  std::vector<std::string> takeWarnings();

  struct State;
  State& state() const { return *state_; }  // for the library's own use

 private:
  std::unique_ptr<State> state_;
};

}  // namespace lavaray::v0

#endif
