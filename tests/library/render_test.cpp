#include <lavaray/renderer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "library/scenes.hpp"

namespace lavaray {
namespace {

const Renderer& renderer() {
  static const auto* renderer = new Renderer;
  return *renderer;
}

TEST(LibraryRender, PictureHasTheSizeThatIsAskedFor) {
  const Scene scene = objectScene();
  const auto sizeOf = [&](int width, int height) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    const Image image = renderer().render(scene, options).image;
    EXPECT_EQ(image.rgb.size(), std::size_t{3} * image.width * image.height);
    return ImageSize{image.width, image.height};
  };
  EXPECT_EQ(sizeOf(0, 0), scene.summary().image);
  EXPECT_EQ(sizeOf(54, 0), (ImageSize{54, 36}));
  EXPECT_EQ(sizeOf(0, 36), (ImageSize{54, 36}));
  EXPECT_EQ(sizeOf(20, 30), (ImageSize{20, 30}));
}

TEST(LibraryRender, CropIsThatPartOfTheWhole) {
  const Rectangle part{20, 10, 70, 50};
  for (const View view : {View::kColor, View::kDepth, View::kCost, View::kNormal}) {
    for (const bool normalized : {false, true}) {
      RenderOptions options;
      options.view = view;
      options.normalize = normalized;
      const Image whole = renderer().render(objectScene(), options).image;
      options.crop = part;
      EXPECT_EQ(renderer().render(objectScene(), options).image.rgb, crop(whole, part).rgb) << name(view);
    }
  }
}

TEST(LibraryRender, RowsThatAreTakenAreThoseOfThePicture) {
  RenderOptions options;
  const Image image = renderer().render(objectScene(), options).image;
  options.keepsPicture = false;
  RenderJob job(renderer().device(), objectScene(), options);
  ASSERT_TRUE(job.canStream());
  EXPECT_EQ(job.secondsElapsed(), 0.0);
  job.begin();
  EXPECT_GT(job.secondsElapsed(), 0.0);
  std::vector<float> values;
  const auto take = [&](const float* rgb) { values.insert(values.end(), rgb, rgb + 3 * image.width); };
  job.run({}, take);
  EXPECT_FALSE(values.empty());
  job.takeRows(take);
  EXPECT_EQ(values, image.rgb);
}

TEST(LibraryRender, TargetErrorIsReached) {
  RenderOptions options;
  options.targetError = 0.02;
  const Statistics statistics = renderer().render(objectScene(), options).statistics;
  EXPECT_EQ(statistics.stopReason, StopReason::kFinished);
  EXPECT_GT(statistics.samplesPerPixel, 1.0);
  EXPECT_LE(statistics.estimatedError, 0.02);
}

TEST(LibraryRender, ProgressStopsIt) {
  RenderOptions options;
  options.samples = 1U << 20U;
  int calls = 0;
  const Picture picture = renderer().render(objectScene(), options, [&](double share) {
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    return ++calls < 5;
  });
  EXPECT_EQ(picture.statistics.stopReason, StopReason::kInterrupted);
  EXPECT_EQ(calls, 5);
  EXPECT_GT(picture.statistics.samplesPerPixel, 0.0);
}

TEST(LibraryRender, WhatACallbackThrowsArrives) {
  RenderOptions options;
  options.samples = 1U << 20U;
  try {
    renderer().render(objectScene(), options, [](double) -> bool { throw std::out_of_range("mine"); });
    FAIL() << "nothing was thrown";
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "mine");
  }
}

TEST(LibraryRender, OptionsOutOfRangeAreRefused) {
  const auto refuses = [](const auto& set) {
    RenderOptions options;
    set(options);
    try {
      renderer().render(objectScene(), options);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage) << error.what();
    }
  };
  refuses([](RenderOptions& options) { options.samples = 0; });
  refuses([](RenderOptions& options) { options.width = -1; });
  refuses([](RenderOptions& options) { options.height = 70000; });
  refuses([](RenderOptions& options) { options.crop = Rectangle{0, 0, 1000, 1}; });
  refuses([](RenderOptions& options) { options.targetError = NAN; });
  refuses([](RenderOptions& options) { options.view = View::kError; });
  refuses([](RenderOptions& options) { options.maxDepth = 1001; });
  refuses([](RenderOptions& options) { options.range = SampleRange{0, 3}; });
}

TEST(LibraryRender, LayersAreNumbers) {
  RenderOptions options;
  options.samples = 4;
  RenderJob job(renderer().device(), objectScene(), options);
  const auto layer = [&](Layer which) {
    std::vector<float> values;
    EXPECT_TRUE(job.takeLayer(which, [&](const float* more, std::size_t count) {
      values.insert(values.end(), more, more + count);
    }));
    return values;
  };
  const std::size_t pixels = job.part().pixels();
  const std::vector<float> objects = layer(Layer::kObject);
  const std::vector<float> normals = layer(Layer::kNormal);
  ASSERT_EQ(objects.size(), pixels);
  ASSERT_EQ(normals.size(), 3 * pixels);
  job.run();
  EXPECT_EQ(layer(Layer::kSamples), std::vector<float>(pixels, 4.0F));
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* n = &normals[3 * i];
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    EXPECT_NEAR(length, objects[i] > 0.0F ? 1.0F : 0.0F, 1e-5F);
  }
}

TEST(LibraryRender, StatisticsCountRays) {
  RenderOptions options;
  options.countRays = true;
  const Statistics statistics = renderer().render(objectScene(), options).statistics;
  EXPECT_GT(statistics.rays.camera, 0U);
  EXPECT_GT(statistics.rays.mirror, 0U);
  EXPECT_GT(statistics.rays.shadow, 0U);
  EXPECT_EQ(statistics.hierarchy.primitives, 2U);
  EXPECT_GT(statistics.activity.seconds, 0.0);
}

// Many spheres, so that rays search the hierarchy.
Scene searchedScene() {
  Scene scene = objectScene();
  for (int i = 0; i < 100; ++i) scene.add(Sphere{{0.2 * i - 10.0, 0.0, -3.0}, 0.3, {}});
  return scene;
}

TEST(LibraryDevice, TuningIsTakenAndChangesNoBit) {
  std::vector<float> usual;
  for (const std::string way : {"auto", "texels,1", "storage,1"}) {
    const Renderer tuned(Device({}, {}, {way, {}}));
    RenderOptions options;
    options.countRays = true;
    const Picture picture = tuned.render(searchedScene(), options);
    if (usual.empty()) usual = picture.image.rgb;
    EXPECT_EQ(picture.image.rgb, usual) << way;
    EXPECT_GT(picture.statistics.rays.nearestHitLanesInUse, 0.0) << way;
    if (way == "auto") continue;
    EXPECT_EQ(picture.statistics.sceneReadAs + ',' + std::to_string(picture.statistics.raysPerInvocation),
              way);
    EXPECT_EQ(tuned.device().tuning(), way + ", as asked for");
  }
  EXPECT_TRUE(isTuningWay("measure"));
  EXPECT_FALSE(isTuningWay("storage,3"));
  EXPECT_THROW(Device({}, {}, {"storage,3", {}}), Error);
}

TEST(LibraryDevice, OneThatIsNotThereIsAnError) {
  const Device device("no such device");
  try {
    Renderer(device).render(objectScene());
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kDevice);
  }
}

TEST(LibraryDevice, ListHasTheOneThatRenders) {
  const std::string mine = renderer().device().info().name;
  const DeviceList list = listDevices();
  EXPECT_TRUE(std::any_of(list.devices.begin(), list.devices.end(),
                          [&](const DeviceInfo& device) { return device.name == mine && device.isUsable; }));
}

}  // namespace
}  // namespace lavaray
