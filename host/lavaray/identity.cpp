#include "lavaray/identity.hpp"

#include <sstream>

#include "bvh/flatten.hpp"
#include "command_line/version.hpp"
#include "film/film_file.hpp"
#include "render/variant.hpp"

namespace lavaray {
namespace {

// Enough digits to tell any two numbers apart.
std::string exactly(double number) {
  std::ostringstream text;
  text.precision(17);
  text << number;
  return text.str();
}

}  // namespace

Identity describeIdentity(const Options& options, const Inputs& inputs, const RenderSettings& settings) {
  const Scene& scene = inputs.scene();
  Identity identity = {{"lavaray", kVersion},
                       {"shader", checksumOf(std::as_bytes(shaderOf(settings, hasFewPrimitives(scene))))},
                       {"scene", inputs.sceneChecksum()}};
  const std::filesystem::path folder = scene.file.parent_path();
  for (const Mesh& mesh : scene.meshes) {
    identity.emplace_back("mesh " + mesh.file.lexically_proximate(folder).string(),
                          checksumOfFile(mesh.file));
  }
  identity.emplace_back("--width", std::to_string(settings.size.width));
  identity.emplace_back("--height", std::to_string(settings.size.height));
  identity.emplace_back("--max-depth", std::to_string(settings.maxDepth));
  identity.emplace_back("--reflect", exactly(options.reflect));
  identity.emplace_back("--light-radius", exactly(options.lightRadius));
  if (settings.targetError) {
    identity.emplace_back("--target-error", exactly(*settings.targetError));
    identity.emplace_back("--max-spp", std::to_string(settings.maxSamples));
  } else {
    identity.emplace_back("--spp", std::to_string(settings.samples));
  }
  if (settings.targetError || settings.samples > 1) {
    identity.emplace_back("--seed", std::to_string(settings.seed));
    identity.emplace_back("--sampler", samplerName(settings.sampler));
    identity.emplace_back("--filter", pixelFilterName(settings.filter));
  }
  return identity;
}

}  // namespace lavaray
