#pragma once

#include <cstdio>
#include <string>

#include "report/pair.hpp"

namespace lavaray {

// Writes one HTML page about pairs of pictures, which needs no other file, no server and no network: the
// pictures and the page's own script and style are in it. Each pair is written when it is added, so only one
// is in memory. A browser decodes no picture that is not looked at. Whether everything was written is for the
// stream's owner to check.
class ReportPage {
 public:
  // `maker` is who wrote the page, with a version.
  ReportPage(std::FILE* stream, const std::string& title, const std::string& maker);
  void add(const ComparedPair& compared);
  void finish();

 private:
  void put(std::string_view text);
  void putPicture(const char* kind, const std::string& base64);

  std::FILE* stream_;
  std::size_t pairs_ = 0;
};

}  // namespace lavaray
