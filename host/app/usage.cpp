#include "app/usage.hpp"

#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

#include "core/numbers.hpp"
#include "core/place.hpp"

namespace lavaray {
namespace {

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end != text.data() + text.size() || error != std::errc()) return std::nullopt;
  return number;
}

template <typename Number>
CLI::Validator within(Number least, Number most, const std::string& kind, const std::string& bounds) {
  return {[=](const std::string& text) {
            const std::optional<Number> number = parse<Number>(text);
            if (number && *number >= least && *number <= most) return std::string();
            return lavaray::quoted(text) + " is not " + kind + " " + bounds;
          },
          bounds};
}

std::string explained(const CLI::ParseError& error) {
  const std::string text = error.what();
  const std::string option = text.substr(0, text.find_first_of(": "));
  const auto contains = [&](std::string_view words) { return text.find(words) != std::string::npos; };
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    if (contains("At Most")) return option + " has too many values";
    return option + (contains("At least") ? " has too few values" : " has no value");
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return option + " is missing";
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) {
    return option + " needs" + text.substr(text.rfind(' '));
  }
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
    return option + " and" + text.substr(text.rfind(' ')) + " exclude each other";
  }
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr && contains(": ")) {
    return text.substr(text.find(": ") + 2) + " cannot be understood";
  }
  return printable(text);
}

}  // namespace

CLI::Validator numberFrom(double least, double most) {
  return within(least, most, "a number from", numberText(least) + " to " + numberText(most));
}

CLI::Validator numberFrom(double least) {
  return within(least, std::numeric_limits<double>::max(), "a number that is",
                numberText(least) + " or more");
}

CLI::Validator integerFrom(std::int64_t least, std::int64_t most) {
  return within(least, most, "an integer from", std::to_string(least) + " to " + std::to_string(most));
}

CLI::Validator integerFrom(std::int64_t least) {
  return within(least, std::numeric_limits<std::int64_t>::max(), "an integer that is",
                std::to_string(least) + " or more");
}

Error usageError(const CLI::ParseError& error, const std::string& program) {
  return {ExitCode::kUsage, explained(error) + "; " + program + " --help lists the options"};
}

}  // namespace lavaray
