#include "report/page.hpp"

#include <cmath>
#include <string_view>

#include "image/false_color.hpp"
#include "report/embedded_picture.hpp"
#include "report/page_source.hpp"
#include "report/pair_json.hpp"

namespace lavaray {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// The colours of FLIP's map for 0, 1/255 and so on, six hexadecimal digits each.
std::string palette() {
  std::string text;
  for (int level = 0; level < 256; ++level) {
    const glm::vec3 color = falseColor(static_cast<float>(level) / 255.0F);
    for (int channel = 0; channel < 3; ++channel) {
      const auto byte = static_cast<unsigned>(std::lround(255.0F * color[channel]));
      text += "0123456789abcdef"[byte / 16];
      text += "0123456789abcdef"[byte % 16];
    }
  }
  return text;
}

bool areEqual(const ComparedPair& compared) {
  return compared.isCompared() && compared.histogram[0] == compared.difference.pixels;
}

}  // namespace

ReportPage::ReportPage(std::FILE* stream, const std::string& title, const std::string& maker)
    : stream_(stream) {
  std::string head(kPageHead);
  const auto fill = [&](std::string_view place, const std::string& text) {
    for (std::size_t at = 0; (at = head.find(place, at)) != std::string::npos; at += text.size()) {
      head.replace(at, place.size(), text);
    }
  };
  fill("{{maker}}", escaped(maker));
  fill("{{palette}}", palette());
  fill("{{title}}", escaped(title));
  put(head);
}

void ReportPage::add(const ComparedPair& compared) {
  put("<script type=\"application/json\" class=\"pair\">" + pairJson(compared) + "</script>\n");
  const auto putImage = [&](const std::string& name, const std::optional<Image>& image) {
    if (!image) return;
    putPicture(name.c_str(), shownPicture(*image));
    if (!isShownExactly(*image)) putPicture((name + "-values").c_str(), valuesPicture(*image));
  };
  putImage("image", compared.image);
  // Of two equal pictures the page shows the first twice.
  if (!areEqual(compared)) {
    putImage("reference", compared.reference);
    if (compared.isCompared()) {
      const Image& image = *compared.image;
      Image difference = differencePicture(image, *compared.reference);
      putPicture("difference", shownPicture(difference));
      putPicture("flip", greyPicture(image.width, image.height, compared.seen.map));
    }
  }
  ++pairs_;
}

void ReportPage::finish() {
  put(kPageTail);
}

void ReportPage::put(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream_);
}

void ReportPage::putPicture(const char* kind, const std::string& base64) {
  put("<script type=\"text/plain\" id=\"" + std::to_string(pairs_) + "-" + kind + "\">");
  put(base64);
  put("</script>\n");
}

}  // namespace lavaray
