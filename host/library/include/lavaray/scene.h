#ifndef LAVARAY_SCENE_H
#define LAVARAY_SCENE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lavaray/statistics.h>
#include <lavaray/types.h>

// What is to be rendered. Numbers are within +-1e15; colours are red, green, blue, each 0 or more.
namespace lavaray::v0 {

using Vec3 = std::array<double, 3>;

inline constexpr int kMaxImageSide = 65535;    // in pixels
inline constexpr double kMaxMagnitude = 1e15;  // of every number

// Looks along -z; +y is up.
struct Camera {
  Vec3 position{};
  double fovDegrees = 60.0;  // vertical, in (0, 180)
  double focalLength =
      500.0;  // distance of the image plane, in pixels, > 0: the picture's height is 2 f tan(fov / 2)
  double aspect = 1.0;  // width / height, > 0
};

// Phong reflection coefficients.
struct Material {
  Vec3 ambient{};
  Vec3 diffuse{};
  Vec3 specular{};
  double shininess = 0.0;  // exponent, 0 or more
  std::optional<Vec3>
      reflectance;  // of a perfect mirror; absent is Defaults::reflect times the specular colour
};

struct Plane {
  Vec3 normal{0.0, 1.0, 0.0};  // any length > 0
  Vec3 point{};
  Material material;
};

struct Sphere {
  Vec3 center{};
  double radius = 1.0;  // > 0
  Material material;
};

struct Triangle {
  std::array<Vec3, 3> vertices{};  // not on a line
  Material material;
};

// A surface of triangles. Those without an area are dropped.
struct Mesh {
  std::vector<double> vertices;      // x, y, z of each
  std::vector<std::uint32_t> faces;  // the numbers of three vertices for each triangle, from 0
  std::vector<double> normals;       // x, y, z of each, of any length > 0; none: triangles are flat
  std::vector<std::uint32_t>
      corners;  // the numbers of three normals for each triangle; empty is those of its vertices
  Material material;
};

struct Light {
  Vec3 position{};
  Vec3 ambient{};
  Vec3 diffuse{};
  Vec3 specular{};
  std::optional<double> radius;  // 0 is a point light; absent is Defaults::lightRadius
};

// For materials that state no reflectance, and lights that state no radius.
struct Defaults {
  double reflect = 0.0;
  double lightRadius = 0.0;
};

// A scene from a file, from text or from objects. Several threads may use one that no thread changes. What
// renders share (the hierarchy over its triangles and spheres) is made by the first of them and kept; copies
// share it as long as they are not changed.
class LAVARAY_API Scene {
 public:
  using Files = std::vector<std::filesystem::path>;

  // Without objects, and with a camera as above.
  Scene();
  ~Scene();
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;

  // Reads a scene file and its meshes. Throws Error(kInput) with file and line; `tried` then gets the files
  // that it has read or tried to read.
  static Scene read(const std::filesystem::path& file, const Defaults& defaults = {}, Files* tried = nullptr);
  // The same for a text in the format of scene files. `file`, which need not exist, is its name for messages;
  // meshes are looked for in that one's folder.
  static Scene parse(std::string_view text, const std::filesystem::path& file = "scene",
                     const Defaults& defaults = {});
  // Reads it again if one of files() is among those that have changed; keeps meshes that have not, and where
  // no geometry has, the hierarchy. Returns whether it did. If it throws Error(kInput), the scene stays as it
  // was but for files().
  bool reread(const Files& changed);

  // The files that read(file) would read, of which this reads only the first.
  static Files filesOf(const std::filesystem::path& file);

  // These throw Error(kInput) saying what is out of range. Of surfaces at the same distance the first added
  // is seen.
  void setCamera(const Camera& camera);
  void add(const Plane& plane);
  void add(const Sphere& sphere);
  void add(const Triangle& triangle);
  void add(const Mesh& mesh);
  void add(const Light& light);
  void setDefaults(const Defaults& defaults);

  Camera camera() const;
  SceneSummary summary() const;
  // What is odd but tolerated, each `file:line: message`.
  const std::vector<std::string>& warnings() const;
  // The scene's file and its meshes', as last read or tried to be read.
  const Files& files() const;

  struct State;
  State& state() const { return *state_; }  // for the library's own use

 private:
  explicit Scene(std::shared_ptr<State> state);
  State& own();
  State& change();

  std::shared_ptr<State> state_;
};

}  // namespace lavaray::v0

#endif
