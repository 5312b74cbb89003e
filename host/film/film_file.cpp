#include "film/film_file.hpp"

#include <xxhash.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "base/byte_reader.hpp"
#include "base/errors.hpp"
#include "base/file_claims.hpp"
#include "interface.h"

namespace lavaray {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "film files hold numbers as they are in memory");

constexpr std::string_view kMagic = "lavaray film 3\n";
// Of the header; whatever has more is not a film.
constexpr std::uint64_t kMaxHeaderBytes = 1U << 24U;
constexpr std::size_t kChunkBytes = 1U << 20U;

using Digest = std::array<std::byte, sizeof(XXH128_canonical_t)>;

Json toJson(const Rectangle& r) {
  return {r.x0, r.y0, r.x1, r.y1};
}

Rectangle rectangle(const Json& json) {
  return {json.at(0), json.at(1), json.at(2), json.at(3)};
}

Json toJson(const FilmHeader& header) {
  Json identity = Json::array();
  for (const auto& [name, value] : header.identity) identity.push_back({name, value});
  return {{"identity", identity},
          {"device", header.device},
          {"kind", static_cast<int>(header.kind)},
          {"size", {header.size.width, header.size.height}},
          {"crop", toJson(header.crop)},
          {"traced", toJson(header.traced)},
          {"range", {header.range.first, header.range.end}},
          {"samples", header.samples},
          {"isComplete", header.isComplete},
          {"round", {header.roundFirst, header.roundSize}},
          {"itemsDone", header.itemsDone},
          {"itemsPending", header.itemsPending},
          {"discoveries", header.discoveries.state()}};
}

FilmHeader fromJson(const Json& json) {
  FilmHeader header;
  for (const Json& entry : json.at("identity")) header.identity.emplace_back(entry.at(0), entry.at(1));
  header.device = json.at("device");
  header.kind = static_cast<SumKind>(json.at("kind").get<int>());
  header.size = {json.at("size").at(0), json.at("size").at(1)};
  header.crop = rectangle(json.at("crop"));
  header.traced = rectangle(json.at("traced"));
  header.range = {json.at("range").at(0), json.at("range").at(1)};
  header.samples = json.at("samples");
  header.isComplete = json.at("isComplete");
  header.roundFirst = json.at("round").at(0);
  header.roundSize = json.at("round").at(1);
  header.itemsDone = json.at("itemsDone");
  header.itemsPending = json.at("itemsPending");
  header.discoveries.restore(json.at("discoveries"));
  return header;
}

std::string hexadecimal(XXH128_hash_t hash) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash);
  std::string text;
  for (const unsigned char byte : canonical.digest) {
    text += "0123456789abcdef"[byte / 16];
    text += "0123456789abcdef"[byte % 16];
  }
  return text;
}

// XXH3 (Collet 2019), 128 bits: it detects damage, not forgery.
class StreamHash {
 public:
  StreamHash() : state_(XXH3_createState()) { XXH3_128bits_reset(state_); }
  ~StreamHash() { XXH3_freeState(state_); }
  StreamHash(const StreamHash&) = delete;
  StreamHash& operator=(const StreamHash&) = delete;
  void add(std::span<const std::byte> bytes) { XXH3_128bits_update(state_, bytes.data(), bytes.size()); }
  [[nodiscard]] Digest digest() const {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_));
    Digest result;
    std::memcpy(result.data(), canonical.digest, result.size());
    return result;
  }

 private:
  XXH3_state_t* state_;
};

template <typename Value>
std::span<const std::byte> bytesOf(const Value& value) {
  return std::as_bytes(std::span(&value, 1));
}

}  // namespace

struct FilmWriter::Checksum : StreamHash {};

FilmWriter::FilmWriter(std::FILE* stream, const FilmHeader& header)
    : stream_(stream), checksum_(std::make_unique<Checksum>()) {
  const std::string text = toJson(header).dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::uint64_t length = text.size();
  write(std::as_bytes(std::span(kMagic)));
  write(bytesOf(length));
  write(std::as_bytes(std::span(text)));
}

FilmWriter::~FilmWriter() = default;

void FilmWriter::write(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;  // the address may then be null, which fwrite does not allow
  checksum_->add(bytes);
  std::fwrite(bytes.data(), 1, bytes.size(), stream_);
}

void FilmWriter::finish() {
  const Digest digest = checksum_->digest();
  std::fwrite(digest.data(), 1, digest.size(), stream_);
}

FilmReader::FilmReader(const std::filesystem::path& file) : file_(file) {
  noteRead(file, "the film");
  stream_ = std::fopen(file.c_str(), "rb");
  if (stream_ == nullptr) failUnreadable(file, std::strerror(errno));
  try {
    readHeader();
    verify();
  } catch (...) {
    std::fclose(stream_);
    throw;
  }
}

FilmReader::~FilmReader() {
  std::fclose(stream_);
}

void FilmReader::fail(const std::string& why) const {
  throw Error(ExitCode::kInput, file_.string() + ": " + why, file_.string());
}

void FilmReader::readAt(std::uint64_t position, std::span<std::byte> bytes) {
  if (bytes.empty()) return;
  if (fseeko(stream_, static_cast<off_t>(position), SEEK_SET) != 0 ||
      std::fread(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) {
    fail("the film ends early or cannot be read");
  }
}

void FilmReader::readHeader() {
  std::string magic(kMagic.size(), '\0');
  std::uint64_t length = 0;
  const bool isFilm = std::fread(magic.data(), 1, magic.size(), stream_) == magic.size() && magic == kMagic;
  if (!isFilm) fail("it is no film of this version of lavaray");
  if (std::fread(&length, sizeof length, 1, stream_) != 1 || length > kMaxHeaderBytes) {
    fail("the film's header is damaged");
  }
  std::string text(length, '\0');
  readAt(kMagic.size() + sizeof length, std::as_writable_bytes(std::span(text)));
  pixelsBegin_ = kMagic.size() + sizeof length + length;
  try {
    header_ = fromJson(Json::parse(text));
  } catch (const nlohmann::json::exception&) {
    fail("the film's header is damaged");
  }
  if (header_.kind != SumKind::kCenter && header_.kind != SumKind::kMean && header_.kind != SumKind::kHalves)
    fail("the film's header is damaged");
}

// A damaged header is noticed here as well, before anything that it says is relied on.
void FilmReader::verify() {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file_, unknown);
  if (unknown || size < pixelsBegin_ + sizeof(Digest)) fail("the film is truncated");
  StreamHash hash;
  std::vector<std::byte> chunk(kChunkBytes);
  for (std::uint64_t position = 0; position < size - sizeof(Digest);) {
    const std::size_t count = std::min<std::uint64_t>(kChunkBytes, size - sizeof(Digest) - position);
    readAt(position, std::span(chunk).first(count));
    hash.add(std::span(chunk).first(count));
    position += count;
  }
  Digest digest;
  readAt(size - sizeof digest, digest);
  if (digest != hash.digest()) fail("the film is truncated or damaged: its checksum is another");
  if (size != pixelsBegin_ + pixelBytes() + header_.itemsPending * sizeof(gpu::WorkItem) + sizeof(Digest)) {
    fail("the film's length is not what its header says");
  }
}

std::uint64_t FilmReader::pixelBytes() const {
  return header_.traced.pixels() * bytesPerPixel(header_.kind);
}

void FilmReader::readRow(int row, std::span<std::byte> bytes) {
  readAt(pixelsBegin_ + static_cast<std::uint64_t>(row) * bytes.size(), bytes);
}

void FilmReader::readPixels(std::span<std::byte> bytes) {
  readAt(pixelsBegin_, bytes);
}

void FilmReader::readItems(std::span<std::byte> bytes) {
  readAt(pixelsBegin_ + pixelBytes(), bytes);
}

std::string checksumOf(std::span<const std::byte> bytes) {
  return hexadecimal(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string checksumOfFile(const std::filesystem::path& file) {
  try {
    const std::string text = readFile(file);
    return checksumOf(std::as_bytes(std::span(text)));
  } catch (const std::system_error& error) {
    failUnreadable(file, error);
  }
}

}  // namespace lavaray
