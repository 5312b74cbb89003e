#include <lavaray/image.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace lavaray {
namespace {

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("lavaray-image-" + name);
}

Image ramp() {
  Image image{5, 3, {}, {}, {}};
  for (int i = 0; i < 45; ++i) image.rgb.push_back(static_cast<float>(i) / 255.0F);
  return image;
}

TEST(LibraryImage, WritesWhatItReads) {
  for (const char* ending : {".bmp", ".png", ".ppm", ".pfm"}) {
    const std::filesystem::path file = scratch("copy") += ending;
    writeImage(ramp(), file);
    EXPECT_EQ(readImage(file).rgb, ramp().rgb) << ending;
    writeImage(readImage(file), file);  // which a program may replace that does not ask for protection
  }
  const Image read = readImage(scratch("copy.png"));
  EXPECT_EQ(read.source.format, "PNG");
  EXPECT_EQ(read.source.maxima[0], 255U);
}

TEST(LibraryImage, EightBitsClampWhatTheyCannotSay) {
  Image image{2, 1, {-1.0F, 0.25F, 300.0F, std::nanf(""), INFINITY, -INFINITY}};
  for (const char* ending : {".bmp", ".png", ".ppm"}) {
    const std::filesystem::path file = scratch("clamped") += ending;
    writeImage(image, file);
    EXPECT_EQ(readImage(file).rgb, (std::vector<float>{0, 63.0F / 255.0F, 1, 0, 1, 0})) << ending;
  }
  writeImage(image, scratch("kept.pfm"));
  EXPECT_EQ(readImage(scratch("kept.pfm")).rgb[2], 300.0F);
}

TEST(LibraryImage, PairsOfFilesAreComparedAndReported) {
  Image other = ramp();
  other.rgb[0] = 1.0F;
  writeImage(ramp(), scratch("ramp.png"));
  writeImage(other, scratch("other.png"));
  ImagePair pair{"ramp", scratch("ramp.png"), scratch("other.png"), "a driver", {}};
  const ComparedPair differs = comparePair(pair);
  EXPECT_EQ(differs.verdict, Verdict::kDiffers);
  EXPECT_EQ(differs.difference.differing, 1U);
  EXPECT_GT(differs.flip, 0.0);
  ASSERT_NE(differs.image, nullptr);
  EXPECT_EQ(differs.image->rgb, ramp().rgb);
  pair.limits.maxDiffering = 1;
  EXPECT_EQ(comparePair(pair).verdict, Verdict::kAlike);
  pair.reference = scratch("missing.png");
  const ComparedPair unreadable = comparePair(pair);
  EXPECT_EQ(unreadable.verdict, Verdict::kUnreadable);
  EXPECT_NE(unreadable.problem.find("missing.png"), std::string::npos);

  const auto report = [&](const std::string& name, ReportFormat format) {
    OutputFile file({"the report", scratch(name)});
    ReportWriter writer(file, format, "Two ramps");
    for (const ComparedPair* compared : {&differs, &unreadable}) writer.add(*compared);
    EXPECT_THROW(writer.add({}), Error);
    writer.finish();
    file.commit();
    std::ifstream stream(scratch(name));
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_NE(report("pairs.html", ReportFormat::kHtml).find("Two ramps"), std::string::npos);
  report("pairs.json", ReportFormat::kJson);
  const std::vector<ImagePair> read = readPairs(scratch("pairs.json"));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].driver, "a driver");
  EXPECT_EQ(read[1].limits.maxDiffering, 1U);
}

TEST(LibraryImage, RowByRowIsTheSameFile) {
  writeImage(ramp(), scratch("whole.png"), {{"Title", "ramp"}});
  OutputFile file({"the image", scratch("rows.png")});
  ImageWriter writer(file, ImageFormat::kPng, {5, 3}, {{"Title", "ramp"}});
  for (std::size_t y = 0; y < 3; ++y) writer.write(&ramp().rgb[15 * y]);
  writer.finish();
  EXPECT_FALSE(std::filesystem::exists(scratch("rows.png")));
  file.commit();
  const auto bytes = [](const std::filesystem::path& name) {
    std::ifstream stream(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(bytes(scratch("rows.png")), bytes(scratch("whole.png")));
  std::filesystem::remove(scratch("rows.png"));
}

TEST(LibraryImage, DifferencesSayWhere) {
  Image other = ramp();
  other.rgb[3 * 7] += 0.5F;  // pixel 7 is (2, 1)
  const Difference difference = compare(other, ramp());
  EXPECT_EQ(difference.pixels, 15U);
  EXPECT_EQ(difference.differing, 1U);
  EXPECT_FLOAT_EQ(static_cast<float>(difference.color.largest), 0.5F);
  EXPECT_EQ(difference.color.x, 2);
  EXPECT_EQ(difference.color.y, 1);
  EXPECT_EQ(compare(other, ramp(), 0.6).differing, 0U);
  EXPECT_EQ(differencePicture(other, ramp()).rgb[3 * 7], 1.0F);
  EXPECT_GT(meanFlip(other, ramp()), 0.0);
  EXPECT_EQ(meanFlip(ramp(), ramp()), 0.0);
  EXPECT_EQ(flipMap(other, ramp()).size(), 15U);
}

TEST(LibraryImage, WhatCannotBeIsRefused) {
  const auto kindOf = [](const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::kInternal;
  };
  EXPECT_EQ(kindOf([] { readImage("/nowhere/image.png"); }), ErrorKind::kInput);
  EXPECT_EQ(kindOf([] { parseImage("P6 1", "cut.ppm"); }), ErrorKind::kInput);
  EXPECT_EQ(kindOf([] { writeImage(ramp(), scratch("image.jpg")); }), ErrorKind::kUsage);
  EXPECT_EQ(kindOf([] { writeImage(ramp(), "/nowhere/image.png"); }), ErrorKind::kOutput);
  EXPECT_EQ(kindOf([] { compare(ramp(), Image{1, 1, {0, 0, 0}, {}, {}}); }), ErrorKind::kUsage);
  EXPECT_EQ(kindOf([] { compare(ramp(), Image{5, 3, {0, 0, 0}, {}, {}}); }), ErrorKind::kUsage);
  EXPECT_EQ(kindOf([] { crop(ramp(), {0, 0, 6, 3}); }), ErrorKind::kUsage);
}

}  // namespace
}  // namespace lavaray
