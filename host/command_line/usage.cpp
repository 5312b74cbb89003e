#include "command_line/usage.hpp"

#include <lavaray/scene.h>
#include <array>
#include <charconv>
#include <iostream>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "command_line/help.hpp"
#include "command_line/shown.hpp"

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

// The shortest text that reads back as the same number.
std::string numberText(double number) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kMaxLength = 60;
  return '"' + shown(text.substr(0, kMaxLength)) + (text.size() > kMaxLength ? "...\"" : "\"");
}

template <typename Number>
CLI::Validator within(Number min, Number max, const std::string& kind, const std::string& bounds) {
  return {[=](const std::string& text) {
            const std::optional<Number> number = parse<Number>(text);
            if (number && *number >= min && *number <= max) return std::string();
            return quoted(text) + " is not " + kind + " " + bounds;
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
  return shown(text);
}

}  // namespace

CLI::Validator numberFrom(double min, double max) {
  return within(min, max, "a number from", numberText(min) + " to " + numberText(max));
}

CLI::Validator numberFrom(double min) {
  return within(min, std::numeric_limits<double>::max(), "a number that is", numberText(min) + " or more");
}

CLI::Validator integerFrom(std::int64_t min, std::int64_t max) {
  return within(min, max, "an integer from", std::to_string(min) + " to " + std::to_string(max));
}

CLI::Validator integerFrom(std::int64_t min) {
  return within(min, std::numeric_limits<std::int64_t>::max(), "an integer that is",
                std::to_string(min) + " or more");
}

CLI::Validator fileName() {
  return {[](const std::string& name) { return name.empty() ? "an empty name is none" : std::string(); }, ""};
}

CLI::Validator fileNameNotStdout() {
  return {[](const std::string& name) {
            if (name == "-") return std::string("- is stdout, which is for pictures; name a file");
            return fileName()(name);
          },
          ""};
}

bool parseCommandLine(CLI::App& app, int argc, const char* const* argv) {
  app.set_help_all_flag("--help-table")->group("");
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::CallForHelp&) {
    std::cout << helpText(app);
    return false;
  } catch (const CLI::CallForAllHelp&) {
    std::cout << helpTable(app);
    return false;
  } catch (const CLI::Success& success) {
    app.exit(success, std::cout, std::cerr);
    return false;
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorKind::kUsage, explained(error) + "; " + app.get_name() + " --help lists the options");
  }
}

void addCropOption(CLI::App& app, std::optional<Rectangle>& crop, const std::string& description) {
  app.add_option_function<std::vector<int>>(
         "--crop",
         [&crop](const std::vector<int>& c) {
           crop = Rectangle{c[0], c[1], c[2], c[3]};
         },
         description)
      ->type_name("X0,Y0,X1,Y1")
      ->delimiter(',')
      ->expected(4)
      ->check(integerFrom(0, kMaxImageSide));
}

}  // namespace lavaray
