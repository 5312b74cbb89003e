#include "scene/scene_block.hpp"

#include <algorithm>
#include <span>

#include "base/number_text.hpp"
#include "base/text_lines.hpp"

namespace lavaray {
namespace {

enum class Rule { kAny, kNotNegative, kPositive, kFieldOfView, kNotZero, kFileName };

struct KeyRule {
  std::string_view key;
  std::size_t count;  // how many numbers
  Rule rule;
  bool isRequired = true;
};

constexpr KeyRule kCameraKeys[] = {{"pos", 3, Rule::kAny},
                                   {"fov", 1, Rule::kFieldOfView},
                                   {"f", 1, Rule::kPositive},
                                   {"a", 1, Rule::kPositive}};
constexpr KeyRule kPlaneKeys[] = {{"nor", 3, Rule::kNotZero}, {"pos", 3, Rule::kAny}};
constexpr KeyRule kSphereKeys[] = {{"pos", 3, Rule::kAny}, {"rad", 1, Rule::kPositive}};
constexpr KeyRule kTriangleKeys[] = {{"v1", 3, Rule::kAny}, {"v2", 3, Rule::kAny}, {"v3", 3, Rule::kAny}};
constexpr KeyRule kMeshKeys[] = {{"file", 0, Rule::kFileName}};
// `col` is the older form of `dif` and `spe` in one; checkComplete accepts it in place of them.
constexpr KeyRule kLightKeys[] = {{"pos", 3, Rule::kAny},
                                  {"amb", 3, Rule::kNotNegative, false},
                                  {"dif", 3, Rule::kNotNegative},
                                  {"spe", 3, Rule::kNotNegative},
                                  {"rad", 1, Rule::kNotNegative, false},
                                  {"col", 3, Rule::kNotNegative, false}};
constexpr KeyRule kMaterialKeys[] = {{"amb", 3, Rule::kNotNegative},
                                     {"dif", 3, Rule::kNotNegative},
                                     {"spe", 3, Rule::kNotNegative},
                                     {"shi", 1, Rule::kNotNegative},
                                     {"ref", 3, Rule::kNotNegative, false}};

struct KindRule {
  std::string_view word;
  ObjectKind kind;
  std::span<const KeyRule> keys;
  bool hasMaterial;
};

const std::array<KindRule, 7> kKinds{{{"camera", ObjectKind::kCamera, kCameraKeys, false},
                                      {"plane", ObjectKind::kPlane, kPlaneKeys, true},
                                      {"sphere", ObjectKind::kSphere, kSphereKeys, true},
                                      {"triangle", ObjectKind::kTriangle, kTriangleKeys, true},
                                      {"mesh", ObjectKind::kMesh, kMeshKeys, true},
                                      {"light", ObjectKind::kLight, kLightKeys, false},
                                      {"model", ObjectKind::kMesh, kMeshKeys, true}}};

const KindRule& kindRule(ObjectKind kind) {
  return *std::ranges::find(kKinds, kind, &KindRule::kind);
}

std::vector<KeyRule> keyRules(ObjectKind kind) {
  const KindRule& rule = kindRule(kind);
  std::vector<KeyRule> rules(rule.keys.begin(), rule.keys.end());
  if (rule.hasMaterial) rules.insert(rules.end(), std::begin(kMaterialKeys), std::end(kMaterialKeys));
  return rules;
}

void append(std::string& list, std::string_view word) {
  if (!list.empty()) list += ", ";
  list += word;
}

std::string allowedKeys(ObjectKind kind) {
  std::string list;
  for (const KeyRule& rule : keyRules(kind)) append(list, rule.key);
  return list;
}

std::array<double, 3> readNumbers(const KeyRule& rule, std::string_view value, const TextLocation& location) {
  std::array<double, 3> numbers{};
  std::size_t count = 0;
  for (std::string_view word = takeWord(value); !word.empty(); word = takeWord(value)) {
    const double number = parseNumber(word, location);
    if (count < numbers.size()) numbers[count] = number;
    ++count;
  }
  if (count != rule.count) {
    failAt(location, backticked(rule.key) + " has " + std::to_string(count) +
                         " numbers, allowed are exactly " + std::to_string(rule.count));
  }
  return numbers;
}

void checkRange(const KeyRule& rule, std::span<const double> numbers, const TextLocation& location) {
  const auto check = [&](auto isAllowed, std::string_view allowed) {
    const auto bad = std::ranges::find_if_not(numbers, isAllowed);
    if (bad == numbers.end()) return;
    failAt(location,
           backticked(rule.key) + " is " + numberText(*bad) + ", allowed is " + std::string(allowed));
  };
  switch (rule.rule) {
    case Rule::kNotNegative:
      return check([](double x) { return x >= 0.0; }, "0 or more");
    case Rule::kPositive:
      return check([](double x) { return x > 0.0; }, "more than 0");
    case Rule::kFieldOfView:
      return check([](double x) { return x > 0.0 && x < 180.0; }, "more than 0 and less than 180");
    case Rule::kNotZero:
      if (std::ranges::any_of(numbers, [](double x) { return x != 0.0; })) return;
      failAt(location, backticked(rule.key) + " is 0 0 0, allowed is any other vector");
    case Rule::kAny:
    case Rule::kFileName:
      return;
  }
}

// The name may be in double quotes.
std::string readFileName(std::string_view value, const TextLocation& location) {
  std::string_view name = value;
  if (value.starts_with('"')) {
    const std::size_t end = value.find('"', 1);
    if (end != value.size() - 1 || end == 0) {
      failAt(location,
             "the quotes in " + quoted(value) + " do not enclose a file name, allowed is \"name\" or name");
    }
    name = value.substr(1, end - 1);
  }
  if (name.empty()) failAt(location, "the file name is empty, allowed is the path of an OBJ file");
  return std::string(name);
}

}  // namespace

std::optional<ObjectKind> objectKind(std::string_view word) {
  const auto found = std::ranges::find(kKinds, word, &KindRule::word);
  if (found == kKinds.end()) return std::nullopt;
  return found->kind;
}

std::string allowedKinds() {
  std::string list;
  for (const KindRule& rule : kKinds) append(list, rule.word);
  return list;
}

void Block::add(std::string_view key, std::string_view value, const TextLocation& location) {
  const std::vector<KeyRule> rules = keyRules(kind_);
  const auto rule = std::ranges::find(rules, key, &KeyRule::key);
  const std::string_view kindWord = kindRule(kind_).word;
  if (rule == rules.end()) {
    failAt(location, "unknown key " + quoted(key) + ", allowed in a " + std::string(kindWord) + " are " +
                         allowedKeys(kind_));
  }
  if (const Entry* earlier = find(key)) {
    failAt(location, backticked(key) + " is repeated, allowed once in a " + std::string(kindWord) +
                         " (it is in line " + std::to_string(earlier->line) + ")");
  }
  rejectTwoColours(key, location);
  Entry entry{.key = rule->key, .line = location.line, .numbers = {}, .text = {}};
  if (rule->rule == Rule::kFileName) {
    entry.text = readFileName(value, location);
  } else {
    entry.numbers = readNumbers(*rule, value, location);
    checkRange(*rule, std::span(entry.numbers).first(rule->count), location);
  }
  entries_.push_back(std::move(entry));
}

void Block::rejectTwoColours(std::string_view key, const TextLocation& location) const {
  if (kind_ != ObjectKind::kLight) return;
  for (const std::string_view colour : {"amb", "dif", "spe"}) {
    if ((key == "col" && has(colour)) || (key == colour && has("col"))) {
      failAt(location, "`col` together with " + backticked(colour) +
                           ", allowed is either `col` or `amb`, `dif`, `spe`");
    }
  }
}

void Block::checkComplete() const {
  std::string missing;
  for (const KeyRule& rule : keyRules(kind_)) {
    const bool isInCol = has("col") && (rule.key == "dif" || rule.key == "spe");
    if (rule.isRequired && !isInCol && !has(rule.key)) append(missing, rule.key);
  }
  if (missing.empty()) return;
  failAt(location_, "missing key " + missing + ", allowed in a " + std::string(kindRule(kind_).word) +
                        " are " + allowedKeys(kind_));
}

const Block::Entry* Block::find(std::string_view key) const {
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  return found == entries_.end() ? nullptr : &*found;
}

TextLocation Block::locationOf(std::string_view key) const {
  const Entry* entry = find(key);
  return {location_.file, entry != nullptr ? entry->line : location_.line};
}

std::string Block::text(std::string_view key) const {
  const Entry* entry = find(key);
  return entry != nullptr ? entry->text : std::string();
}

double Block::number(std::string_view key) const {
  return vector(key).x;
}

glm::dvec3 Block::vector(std::string_view key) const {
  const Entry* entry = find(key);
  return entry != nullptr ? glm::dvec3(entry->numbers[0], entry->numbers[1], entry->numbers[2])
                          : glm::dvec3(0.0);
}

}  // namespace lavaray
