#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "base/text_location.hpp"

namespace lavaray {

// The vocabulary of the scene format: its kinds of object, the keys of each kind, and the values that each
// key takes.

enum class ObjectKind { kCamera, kPlane, kSphere, kTriangle, kMesh, kLight };

std::optional<ObjectKind> objectKind(std::string_view word);

// All words that objectKind knows, for messages.
std::string allowedKinds();

// One object of a scene file: its kind and its keys, checked one by one. Every complaint is an Error(kInput).
class Block {
 public:
  Block(ObjectKind kind, const TextLocation& location) : kind_(kind), location_(location) {}

  [[nodiscard]] ObjectKind kind() const { return kind_; }
  [[nodiscard]] const TextLocation& location() const { return location_; }  // of the kind's line
  [[nodiscard]] bool isEmpty() const { return entries_.empty(); }

  // Adds a key with its value as written. Throws if the kind has no such key, if the key is there already, or
  // if the value is not allowed.
  void add(std::string_view key, std::string_view value, const TextLocation& location);

  // Throws if a required key is missing.
  void checkComplete() const;

  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
  [[nodiscard]] TextLocation locationOf(std::string_view key) const;
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;  // 0 if the key is absent, as is vector()
  [[nodiscard]] glm::dvec3 vector(std::string_view key) const;

 private:
  struct Entry {
    std::string_view key;
    std::size_t line;
    std::array<double, 3> numbers;
    std::string text;
  };
  [[nodiscard]] const Entry* find(std::string_view key) const;
  void rejectTwoColours(std::string_view key, const TextLocation& location) const;

  ObjectKind kind_;
  TextLocation location_;
  std::vector<Entry> entries_;
};

}  // namespace lavaray
