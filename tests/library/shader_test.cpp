#include <lavaray/renderer.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "library/scenes.hpp"

namespace lavaray {
namespace {

const Renderer& renderer() {
  static const auto* renderer = new Renderer;
  return *renderer;
}

// Two octahedra, so that there is a hierarchy to be traversed, before a plane.
Scene meshScene() {
  Scene scene;
  scene.setCamera({{0, 1, 10}, 40.0, 100.0, 1.5});
  scene.add(octahedron({-1, 0, 0}));
  scene.add(octahedron({1.5, 0.5, -1}));
  scene.add(Plane{{0, 1, 0}, {0, -1, 0}, {}});
  return scene;
}

// A shader in a file of the running test, which sets each pixel to `value`.
class ShaderFile {
 public:
  explicit ShaderFile(const std::string& value, std::string header = "pixel.glsl")
      : header_(std::move(header)) {
    write(value);
  }
  ~ShaderFile() { std::filesystem::remove_all(path_.parent_path()); }
  ShaderFile(const ShaderFile&) = delete;
  ShaderFile& operator=(const ShaderFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void write(const std::string& value) const {
    std::ofstream(path_) << "#version 460\n"
                            "#extension GL_GOOGLE_include_directive : require\n"
                            "#include \"pixel.glsl\"\n"
                            "#include \""
                         << header_
                         << "\"\n"
                            "void main() {\n"
                            "  const Pixel pixel = thisPixel();\n"
                            "  if (!pixel.isThere) return;\n"
                            "  uint tests = 0u;\n"
                            "  const Hit hit = nearestHit(rayThrough(pixel), kNoSurface, tests);\n"
                            "  setPixel(pixel, "
                         << value << ");\n}\n";
  }

 private:
  static std::filesystem::path folder() {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("lavaray-shader-" + test);
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
  }

  std::string header_;
  std::filesystem::path path_ = folder() / "own.comp";
};

constexpr const char* kPosition = "vec3(pixel.position, -2.5)";
constexpr const char* kObject =
    "vec3(isHit(hit) ? float(surfacePoint(rayThrough(pixel), hit).object + 1u) : 0.0)";

TEST(LibraryShader, ValuesArriveAsTheyAre) {
  const ShaderFile file(kPosition);
  const Shader shader(file.path());
  RenderOptions options;
  options.crop = Rectangle{5, 20, 90, 51};
  const Image image = renderer().run(shader, objectScene(), options);
  ASSERT_EQ(image.width, 85);
  ASSERT_EQ(image.height, 31);
  auto value = image.rgb.begin();
  for (int y = 20; y < 51; ++y) {
    for (int x = 5; x < 90; ++x) {
      ASSERT_EQ(std::vector<float>(value, value + 3),
                (std::vector<float>{static_cast<float>(x), static_cast<float>(y), -2.5F}));
      value += 3;
    }
  }
}

TEST(LibraryShader, SeesTheObjectsOfTheLayer) {
  const ShaderFile file(kObject);
  const Shader shader(file.path());
  for (const Scene& scene : {objectScene(), meshScene(), Scene()}) {
    const Image image = renderer().run(shader, scene);
    std::vector<float> expected;
    RenderJob job(renderer().device(), scene, {});
    ASSERT_TRUE(job.takeLayer(Layer::kObject, [&](const float* values, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) expected.insert(expected.end(), 3, values[i]);
    }));
    EXPECT_EQ(image.rgb, expected);
  }
}

TEST(LibraryShader, CountsTests) {
  const ShaderFile file("vec3(tests, isHit(hit) && hit.surface < 16u, 0.0)");
  const Shader shader(file.path());
  const Image image = renderer().run(shader, meshScene());
  EXPECT_EQ(image.rgb[0], 2.0F) << "the root and the plane";
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const bool isTriangle = image.rgb[i + 1] == 1.0F;
    EXPECT_GE(image.rgb[i], isTriangle ? 3.0F : 2.0F);
    triangles += isTriangle;
  }
  EXPECT_GT(triangles, 100U);
}

TEST(LibraryShader, ChangesAreTakenUp) {
  const ShaderFile file("vec3(1.0)");
  Shader shader(file.path());
  const std::vector<float> first = renderer().run(shader, objectScene()).rgb;
  while (shader.reload()) {  // until it is certain that no change was missed
  }
  EXPECT_FALSE(shader.reload());
  file.write("vec3(2.0)");
  EXPECT_TRUE(shader.reload());
  const std::vector<float> second = renderer().run(shader, objectScene()).rgb;
  EXPECT_EQ(second, std::vector<float>(first.size(), 2.0F));
}

TEST(LibraryShader, HeadersOfItsOwnAreWatched) {
  const ShaderFile file("vec3(kGrey)", "grey.glsl");
  const std::filesystem::path header = file.path().parent_path() / "grey.glsl";
  std::ofstream(header) << "const float kGrey = 0.5;\n";
  Shader shader(file.path());
  EXPECT_EQ(std::count(shader.files().begin(), shader.files().end(), header), 1);
  std::ofstream(header) << "const float kGrey = 0.25;\n";
  EXPECT_TRUE(shader.reload());
  EXPECT_EQ(renderer().run(shader, objectScene()).rgb[0], 0.25F);
}

TEST(LibraryShader, AMistakeLeavesTheLastGoodOne) {
  const ShaderFile file("vec3(1.0)");
  Shader shader(file.path());
  file.write("nope");
  try {
    (void)shader.reload();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_EQ(error.file(), file.path().string());
    EXPECT_EQ(error.line(), 10U);
    EXPECT_EQ(error.what(), file.path().string() + ":10: 'nope': undeclared identifier");
  }
  EXPECT_EQ(renderer().run(shader, objectScene()).rgb[0], 1.0F);
  file.write("vec3(3.0)");
  EXPECT_TRUE(shader.reload());
  EXPECT_EQ(renderer().run(shader, objectScene()).rgb[0], 3.0F);
}

TEST(LibraryShader, OutlivesTheThreadThatMadeIt) {
  const ShaderFile file("vec3(1.0)");
  std::optional<Shader> shader;
  std::thread([&] { shader.emplace(file.path()); }).join();
  file.write("vec3(2.0)");
  EXPECT_TRUE(shader->reload());
  EXPECT_EQ(renderer().run(*shader, objectScene()).rgb[0], 2.0F);
}

TEST(LibraryShader, ProgressStopsIt) {
  const ShaderFile file("vec3(1.0)");
  const Shader shader(file.path());
  const Image image = renderer().run(shader, objectScene(), {}, [](double) { return false; });
  EXPECT_EQ(image.rgb, std::vector<float>(image.rgb.size()));
  const auto thrower = [](double) -> bool { throw std::runtime_error("mine"); };
  EXPECT_THROW((void)renderer().run(shader, objectScene(), {}, thrower), std::runtime_error);
}

TEST(LibraryShader, OptionsThatItCannotHaveAreRefused) {
  const ShaderFile file("vec3(1.0)");
  const Shader shader(file.path());
  RenderOptions options;
  options.samples = 2;
  try {
    (void)renderer().run(shader, objectScene(), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
  }
}

}  // namespace
}  // namespace lavaray
