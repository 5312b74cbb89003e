// Films and what is merged of them, made here without a renderer.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "base/errors.hpp"
#include "film/film_file.hpp"
#include "film/merge.hpp"

namespace lavaray {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, empty.
class FilmTest : public testing::Test {
 protected:
  FilmTest()
      : folder_(fs::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~FilmTest() override { fs::remove_all(folder_); }

  const fs::path folder_;
};

constexpr std::uint32_t kSamples = 12;
constexpr ImageSize kSize{7, 5};

// Sample i of a pixel, any function that is never the same.
glm::vec3 sampleOf(int x, int y, std::uint32_t i) {
  std::mt19937 random(static_cast<unsigned>(x + 100 * y + 10000 * static_cast<int>(i)));
  std::uniform_real_distribution<float> value(0.0F, 1.0F);
  return {value(random), value(random), value(random)};
}

FilmHeader headerOf(const Rectangle& crop, const SampleRange& range) {
  FilmHeader header;
  header.identity = {{"scene", "abc"}, {"--spp", std::to_string(kSamples)}};
  header.device = "a device";
  header.kind = SumKind::kMean;
  header.size = kSize;
  header.crop = crop;
  header.traced = crop;
  header.range = range;
  header.samples = kSamples;
  header.isComplete = true;
  return header;
}

void writeFilm(const fs::path& file, const FilmHeader& header) {
  std::vector<PixelSum> sums;
  for (int y = header.traced.y0; y < header.traced.y1; ++y) {
    for (int x = header.traced.x0; x < header.traced.x1; ++x) {
      PixelSum& sum = sums.emplace_back();
      for (std::uint32_t i = header.range.first; i < header.range.end; ++i) sum.add(sampleOf(x, y, i), 1);
    }
  }
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  ASSERT_NE(stream, nullptr);
  FilmWriter writer(stream, header);
  writer.write(std::as_bytes(std::span(sums)));
  writer.finish();
  std::fclose(stream);
}

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void writeBytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

template <typename Action>
std::string messageOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), ExitCode::kInput);
    return error.what();
  }
  return "";
}

TEST_F(FilmTest, KeepsItsHeaderAndItsPixels) {
  FilmHeader header = headerOf({1, 2, 6, 5}, {4, 8});
  header.roundFirst = 4;
  header.roundSize = 4;
  header.itemsDone = 15;
  writeFilm(folder_ / "a.film", header);
  FilmReader film(folder_ / "a.film");
  EXPECT_EQ(film.header().identity, header.identity);
  EXPECT_EQ(film.header().device, header.device);
  EXPECT_EQ(film.header().kind, header.kind);
  EXPECT_EQ(film.header().size, header.size);
  EXPECT_EQ(film.header().crop, header.crop);
  EXPECT_EQ(film.header().range, header.range);
  EXPECT_EQ(film.header().samples, header.samples);
  EXPECT_EQ(film.header().isComplete, header.isComplete);
  EXPECT_EQ(film.header().itemsDone, header.itemsDone);
  std::vector<PixelSum> row(5);
  film.readRow(1, std::as_writable_bytes(std::span(row)));
  PixelSum expected;
  for (std::uint32_t i = 4; i < 8; ++i) expected.add(sampleOf(3, 3, i), 1);
  EXPECT_EQ(row[2].mean(), expected.mean());
  EXPECT_EQ(row[2].samples(), 4U);
}

TEST_F(FilmTest, NoticesEachByteThatIsAnotherAndEachThatIsMissing) {
  writeFilm(folder_ / "a.film", headerOf({0, 0, 3, 2}, {0, kSamples}));
  const std::string good = bytesOf(folder_ / "a.film");
  std::mt19937 random(1);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ static_cast<char>(1U << (random() % 8)));
    writeBytes(folder_ / "bad.film", bad);
    const std::string message = messageOf([&] { FilmReader film(folder_ / "bad.film"); });
    ASSERT_NE(message.find("bad.film: "), std::string::npos) << "byte " << i << ": " << message;
    writeBytes(folder_ / "short.film", good.substr(0, i));
    ASSERT_NE(messageOf([&] { FilmReader film(folder_ / "short.film"); }), "") << i << " bytes";
  }
  writeBytes(folder_ / "long.film", good + "x");
  EXPECT_NE(messageOf([&] { FilmReader film(folder_ / "long.film"); }), "");
}

TEST_F(FilmTest, MergesPartsOfAnyShapeToTheBitsOfTheWhole) {
  const std::vector<std::pair<Rectangle, SampleRange>> parts = {
      {{0, 0, 7, 2}, {0, 4}},  {{0, 0, 4, 2}, {4, 12}}, {{4, 0, 7, 2}, {4, 8}},
      {{4, 0, 7, 2}, {8, 12}}, {{0, 2, 3, 5}, {0, 12}}, {{3, 2, 7, 5}, {0, 12}},
  };
  std::vector<fs::path> files;
  for (const auto& [crop, range] : parts) {
    files.push_back(folder_ / (std::to_string(files.size()) + ".film"));
    writeFilm(files.back(), headerOf(crop, range));
  }
  Merge merge(files);
  merge.checkCoverage({0, 0, kSize.width, kSize.height});
  std::vector<float> row(3 * static_cast<std::size_t>(kSize.width));
  for (int y = 0; y < kSize.height; ++y) {
    merge.readRow(y, 0, row);
    for (int x = 0; x < kSize.width; ++x) {
      PixelSum expected;
      for (std::uint32_t i = 0; i < kSamples; ++i) expected.add(sampleOf(x, y, i), 1);
      const glm::vec3 mean(expected.mean());
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(row[3 * static_cast<std::size_t>(x) + channel], mean[channel]) << x << ", " << y;
      }
    }
  }
}

TEST_F(FilmTest, NamesWhatIsMissingOrThereTwice) {
  writeFilm(folder_ / "a.film", headerOf({0, 0, 7, 5}, {0, 4}));
  writeFilm(folder_ / "b.film", headerOf({0, 0, 7, 3}, {4, 12}));
  const Rectangle whole{0, 0, kSize.width, kSize.height};
  EXPECT_EQ(messageOf([&] {
              Merge({folder_ / "a.film", folder_ / "b.film"}).checkCoverage(whole);
            }),
            "pixels 0,3 to 7,5, samples 4:12 are in no part");
  EXPECT_EQ(messageOf([&] {
              Merge({folder_ / "a.film", folder_ / "b.film"}).checkCoverage({0, 0, 7, 3});
            }),
            "");
  writeFilm(folder_ / "c.film", headerOf({2, 3, 7, 5}, {0, 12}));
  const std::string message = messageOf([&] {
    Merge({folder_ / "a.film", folder_ / "b.film", folder_ / "c.film"}).checkCoverage(whole);
  });
  EXPECT_NE(message.find("pixels 0,3 to 2,5, samples 4:12 are in no part"), std::string::npos) << message;
  EXPECT_NE(message.find("pixels 2,3 to 7,5, samples 0:4 are in both " + (folder_ / "a.film").string() +
                         " and " + (folder_ / "c.film").string()),
            std::string::npos)
      << message;
}

TEST_F(FilmTest, RefusesPartsOfAnotherPictureAndUnfinishedOnes) {
  writeFilm(folder_ / "a.film", headerOf({0, 0, 7, 5}, {0, 4}));
  FilmHeader other = headerOf({0, 0, 7, 5}, {4, 12});
  other.identity[0].second = "def";
  writeFilm(folder_ / "b.film", other);
  const std::string message = messageOf([&] { Merge({folder_ / "a.film", folder_ / "b.film"}); });
  EXPECT_NE(message.find("b.film: is of another picture"), std::string::npos) << message;
  EXPECT_NE(message.find("scene is abc here and def there"), std::string::npos) << message;
  FilmHeader unfinished = headerOf({0, 0, 7, 5}, {4, 12});
  unfinished.isComplete = false;
  writeFilm(folder_ / "c.film", unfinished);
  EXPECT_NE(messageOf([&] {
              Merge({folder_ / "a.film", folder_ / "c.film"});
            }).find("c.film: is not complete"),
            std::string::npos);
}

TEST_F(FilmTest, BlackPixelsOfAPartAreNotInItsFile) {
  FilmHeader header = headerOf({0, 0, 7, 5}, {0, kSamples});
  header.traced = {2, 1, 5, 4};
  writeFilm(folder_ / "a.film", header);
  Merge merge({folder_ / "a.film"});
  merge.checkCoverage({0, 0, kSize.width, kSize.height});
  std::vector<float> row(3 * static_cast<std::size_t>(kSize.width));
  merge.readRow(0, 0, row);
  EXPECT_EQ(row, std::vector<float>(row.size()));
  merge.readRow(2, 0, row);
  EXPECT_EQ(row[3], 0.0F);
  EXPECT_GT(row[6], 0.0F);
  EXPECT_EQ(row[15], 0.0F);
}

}  // namespace
}  // namespace lavaray
