#include <iomanip>
#include <ostream>

#include "report.hpp"

namespace lavaray::bench {
namespace {

// Text of this program's own making: it has no control characters.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

template <typename Element, typename Write>
void writeList(std::ostream& out, const std::vector<Element>& elements, const Write& write) {
  out << '[';
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i > 0) out << ", ";
    write(elements[i]);
  }
  out << ']';
}

void writeOptional(std::ostream& out, const std::optional<std::size_t>& value) {
  if (value) {
    out << *value;
  } else {
    out << "null";
  }
}

void writeTimings(std::ostream& out, const std::vector<Timing>& timings) {
  const auto number = [&](double value) { out << value; };
  writeList(out, timings, [&](const Timing& timing) {
    out << "{\"name\": " << quoted(timing.name) << ", \"cpu\": ";
    writeList(out, timing.cpu, number);
    out << ", \"wall\": ";
    writeList(out, timing.wall, number);
    out << '}';
  });
}

void writeBatch(std::ostream& out, const BatchResult& batch) {
  out << "\n    {\"name\": " << quoted(batch.name) << ", \"rays\": " << batch.rays
      << ", \"hits\": " << batch.hits << ", \"unfinished\": " << batch.unfinished << ", \"disagreements\": ";
  writeOptional(out, batch.disagreements);
  out << ", \"timings\": ";
  writeTimings(out, batch.timings);
  out << '}';
}

void writeScene(std::ostream& out, const SceneResult& scene) {
  out << "\n  {\"name\": " << quoted(scene.name) << ", \"what\": " << quoted(scene.what)
      << ", \"spheres\": " << (scene.isSpheres ? "true" : "false") << ", \"primitives\": " << scene.primitives
      << ", \"bytes\": " << scene.bytes << ", \"peer_bytes\": ";
  writeOptional(out, scene.peerBytes);
  out << ",\n   \"batches\": ";
  writeList(out, scene.batches, [&](const BatchResult& batch) { writeBatch(out, batch); });
  out << ",\n   \"picture\": {\"rays\": " << scene.picture.rays << ", \"differing_pixels\": ";
  writeOptional(out, scene.picture.differingPixels);
  out << ", \"timings\": ";
  writeTimings(out, scene.picture.timings);
  out << "},\n   \"builds\": ";
  writeTimings(out, scene.builds);
  out << '}';
}

}  // namespace

void writeJson(std::ostream& out, const Results& results) {
  out << std::setprecision(6) << "{\"device\": " << quoted(results.device)
      << ", \"peer\": " << quoted(results.peer) << ", \"threads\": " << results.threads << ", \"size\": ["
      << results.size.width << ", " << results.size.height << "], \"rounds\": " << results.rounds
      << ",\n \"skipped\": ";
  writeList(out, results.skipped, [&](const std::string& reason) { out << quoted(reason); });
  out << ",\n \"scenes\": ";
  writeList(out, results.scenes, [&](const SceneResult& scene) { writeScene(out, scene); });
  out << "}\n";
}

}  // namespace lavaray::bench
