#include "report/pair_json.hpp"

#include <array>
#include <cmath>
#include <system_error>

#include <nlohmann/json.hpp>

#include "base/byte_reader.hpp"
#include "base/errors.hpp"
#include "base/file_claims.hpp"
#include "base/printable.hpp"

namespace lavaray {
namespace {

using Json = nlohmann::ordered_json;

// To be raised with every entry that is removed or renamed, or changes its meaning.
constexpr int kSchema = 1;

constexpr std::array kVerdicts = {"alike",         "differs",           "sizes differ",
                                  "image missing", "reference missing", "unreadable"};

template <typename Value>
Json orNull(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json limitsJson(const Limits& limits) {
  return {{"tolerance", orNull(limits.tolerance)},
          {"maxDiffering", orNull(limits.maxDiffering)},
          {"maxRmse", orNull(limits.maxRmse)},
          {"maxFlip", orNull(limits.maxFlip)}};
}

Limits limitsOf(const Json& json) {
  Limits limits;
  const auto read = [&](const char* key, auto& limit) {
    if (const Json& value = json.at(key); !value.is_null()) limit = value;
  };
  read("tolerance", limits.tolerance);
  read("maxDiffering", limits.maxDiffering);
  read("maxRmse", limits.maxRmse);
  read("maxFlip", limits.maxFlip);
  return limits;
}

Json imageJson(const std::filesystem::path& file, const std::optional<Image>& image) {
  if (file.empty()) return nullptr;
  Json json = {{"file", file.string()}};
  if (!image) return json;
  json.update({{"width", image->width},
               {"height", image->height},
               {"format", image->source.format},
               {"maxima", image->source.maxima},
               {"alpha", !image->alpha.empty()},
               {"notes", image->source.notes}});
  for (const auto& [keyword, text] : image->source.texts) {
    if (keyword == "Device") json["device"] = text;
  }
  return json;
}

Json channelJson(const ChannelDifference& channel) {
  return {{"differing", channel.differing},
          {"largest", channel.largest * 255.0},
          {"x", channel.x},
          {"y", channel.y},
          {"rmse", channel.rmse}};
}

Json histogramJson(const DifferenceHistogram& histogram) {
  Json json = Json::array();
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    const bool isLast = i == kHistogramLevels.size();
    json.push_back({{"upTo", isLast ? Json() : Json(kHistogramLevels[i])}, {"pixels", histogram[i]}});
  }
  return json;
}

Json differenceJson(const ComparedPair& compared) {
  const Difference& difference = compared.difference;
  Json json = {{"pixels", difference.pixels},
               {"differing", difference.differing},
               {"finite", difference.finite},
               {"unlike", difference.unlike},
               {"unlikeX", difference.unlikeX},
               {"unlikeY", difference.unlikeY},
               {"rmse", difference.color.rmse},
               {"psnr", psnr(difference.color.rmse)},
               {"meanFlip", compared.seen.mean},
               {"color", channelJson(difference.color)},
               {"histogram", histogramJson(compared.histogram)}};
  if (!compared.image->alpha.empty() || !compared.reference->alpha.empty()) {
    json["alpha"] = channelJson(difference.alpha);
  }
  return json;
}

std::string contents(const std::filesystem::path& file) {
  noteRead(file, "the comparison");
  try {
    return readFile(file);
  } catch (const std::system_error& error) {
    failUnreadable(file, error);
  }
}

}  // namespace

std::string pairJson(const ComparedPair& compared) {
  const Pair& pair = compared.pair;
  Json json = {{"name", pair.name},
               {"verdict", kVerdicts.at(static_cast<std::size_t>(compared.verdict))},
               {"image", imageJson(pair.image, compared.image)},
               {"reference", imageJson(pair.reference, compared.reference)},
               {"driver", pair.driver},
               {"limits", limitsJson(pair.limits)}};
  if (!compared.problem.empty()) json["problem"] = compared.problem;
  if (!compared.comparedAs.empty()) json["comparedAs"] = compared.comparedAs;
  if (compared.isCompared()) json["difference"] = differenceJson(compared);
  // A file's name need not be UTF-8, which JSON must be. Nothing beyond ASCII, and no `<`, leaves room for a
  // doubt about what a browser makes of it inside of a script element.
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
  return text;
}

PairsFile::PairsFile(std::FILE* stream, const std::string& version) : stream_(stream) {
  std::fprintf(stream_, "{\"schema\": %d, \"lavaray\": \"%s\", \"pairs\": [", kSchema, version.c_str());
}

void PairsFile::add(const ComparedPair& compared) {
  std::fputs(isFirst_ ? "\n" : ",\n", stream_);
  isFirst_ = false;
  std::fputs(pairJson(compared).c_str(), stream_);
}

void PairsFile::finish() {
  std::fputs("\n]}\n", stream_);
}

std::vector<Pair> readPairs(const std::filesystem::path& file) {
  std::vector<Pair> pairs;
  try {
    const Json all = Json::parse(contents(file));
    for (const Json& json : all.at("pairs")) {
      const auto path = [&](const char* key) {
        const Json& image = json.at(key);
        return image.is_null() ? std::filesystem::path()
                               : std::filesystem::path(image.at("file").get<std::string>());
      };
      if (path("image").empty() && path("reference").empty()) {
        throw Error(ExitCode::kInput, printable(file.native()) + ": names a pair without any image");
      }
      pairs.push_back({json.at("name"), path("image"), path("reference"), json.at("driver"),
                       limitsOf(json.at("limits"))});
    }
  } catch (const Json::parse_error& error) {
    throw Error(ExitCode::kInput,
                printable(file.native()) + ": is no JSON from byte " + std::to_string(error.byte) + " on");
  } catch (const Json::exception&) {
    throw Error(ExitCode::kInput,
                printable(file.native()) + ": is no comparison as lavaray-diff --json writes it");
  }
  return pairs;
}

}  // namespace lavaray
