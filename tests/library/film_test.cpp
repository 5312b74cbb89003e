#include <lavaray/renderer.h>

#include <filesystem>

#include <gtest/gtest.h>

#include "library/scenes.hpp"

namespace lavaray {
namespace {

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("lavaray-film-" + name);
}

void write(RenderJob& job, const std::filesystem::path& file) {
  OutputFile output({"the film", file});
  job.writeFilm(output);
  output.commit();
}

class LibraryFilm : public testing::Test {
 protected:
  LibraryFilm() {
    options_.samples = 64;
    options_.keepsFilm = true;
  }
  Image whole() { return Renderer(device_).render(scene_, options_).image; }

  Device device_;
  Scene scene_ = objectScene();
  RenderOptions options_;
};

TEST_F(LibraryFilm, ResumedRenderIsThatWithoutAStop) {
  RenderJob first(device_, scene_, options_);
  int calls = 0;
  first.run([&] { return ++calls < 2; });
  write(first, scratch("stopped"));
  EXPECT_FALSE(readFilmInfo(scratch("stopped")).isComplete);
  RenderJob second(device_, scene_, options_);
  EXPECT_TRUE(second.resume(scratch("stopped")).empty());
  second.run();
  EXPECT_EQ(second.image().rgb, whole().rgb);
}

TEST_F(LibraryFilm, MergedPartsAreTheWhole) {
  const Image image = whole();
  std::vector<std::filesystem::path> parts;
  for (const SampleRange range : {SampleRange{0, 32}, SampleRange{32, 64}}) {
    for (const Rectangle& part :
         {Rectangle{0, 0, 40, image.height}, Rectangle{40, 0, image.width, image.height}}) {
      options_.range = range;
      options_.crop = part;
      RenderJob job(device_, scene_, options_);
      job.run();
      parts.push_back(scratch("part" + std::to_string(parts.size())));
      write(job, parts.back());
    }
  }
  FilmMerge merge(parts);
  EXPECT_EQ(merge.image({0, 0, image.width, image.height}).rgb, image.rgb);
  parts.pop_back();
  EXPECT_THROW(FilmMerge(parts).checkCoverage({0, 0, image.width, image.height}), Error);
}

TEST_F(LibraryFilm, FilmOfAnotherSceneIsRefused) {
  RenderJob job(device_, scene_, options_);
  job.run();
  write(job, scratch("other"));
  scene_.add(Sphere{{1, 1, 1}, 0.2, {}});
  RenderJob changed(device_, scene_, options_);
  try {
    changed.resume(scratch("other"));
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(error.what()).find("objects"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lavaray
