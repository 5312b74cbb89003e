#include "command_line/help.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace lavaray {
namespace {

// An argument or option, in words for the user.
struct Entry {
  bool isArgument;
  std::string names;
  std::string value;    // what it takes, or nothing
  std::string allowed;  // the values, if they are checked
  std::string text;     // sentences
};

// CLI11 throws if there is no check.
std::string checkedFor(CLI::Option& option) {
  try {
    return option.get_validator()->get_description();
  } catch (const CLI::OptionNotFound&) {
    return {};
  }
}

bool takesMany(const CLI::Option& option) {
  return option.get_items_expected_max() > 1;
}

std::string spaced(const std::string& names) {
  std::string result;
  for (const char c : names) result += c == ',' ? std::string(", ") : std::string(1, c);
  return result;
}

std::string sentence(std::string text) {
  if (!text.empty() && std::string_view(".!?").find(text.back()) == std::string_view::npos) text += '.';
  return text;
}

// In the order of the table: CLI11 orders them by their addresses.
std::string listed(const std::string& beginning, const std::set<CLI::Option*>& others, CLI::App& app) {
  std::string names;
  for (CLI::Option* option : app.get_options()) {
    if (others.contains(option)) names += (names.empty() ? " " : ", ") + option->get_name();
  }
  return names.empty() ? "" : " " + beginning + names + ".";
}

Entry makeEntry(CLI::Option& option, CLI::App& app) {
  Entry entry;
  entry.isArgument = option.get_positional();
  entry.names = entry.isArgument ? option.get_name(true) : spaced(option.get_name(false, true));
  entry.allowed = checkedFor(option);
  if (!entry.isArgument && option.get_type_size() != 0) {
    entry.value = option.get_type_name();
    // CLI11 appends the checks to the type.
    if (!entry.allowed.empty()) entry.value.resize(entry.value.rfind(":" + entry.allowed));
  }
  entry.text = sentence(option.get_description());
  if (!entry.allowed.empty()) entry.text += " Allowed: " + entry.allowed + ".";
  if (!option.get_default_str().empty()) entry.text += " Default: " + option.get_default_str() + ".";
  entry.text += listed("Only with", option.get_needs(), app) + listed("Not with", option.get_excludes(), app);
  return entry;
}

std::vector<Entry> makeEntries(CLI::App& app) {
  std::vector<Entry> entries;
  for (CLI::Option* option : app.get_options()) {
    const bool isHidden = option->get_group().empty();
    if (!isHidden) entries.push_back(makeEntry(*option, app));
  }
  return entries;
}

std::string usage(CLI::App& app) {
  std::string text = "[options]";
  for (CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true) + (takesMany(*option) ? "..." : "");
    text += option->get_required() ? " " + name : " [" + name + "]";
  }
  return text;
}

// `head` and beside it, from column `begin` on, the words of `text`, in lines of at most 80 columns.
std::string beside(std::string head, const std::string& text, std::size_t begin) {
  constexpr std::size_t kWidth = 80;
  std::string lines;
  std::string line = std::move(head);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() > begin && line.size() + 1 + word.size() > kWidth) {
      lines += line + "\n";
      line.clear();
    }
    if (line.size() < begin) {
      line.resize(begin, ' ');
    } else if (!line.empty()) {
      line += ' ';
    }
    line += word;
  }
  return lines + line + "\n";
}

std::string section(const std::string& title, const std::vector<Entry>& entries, bool ofArguments) {
  constexpr std::size_t kTextColumn = 26;
  std::string text;
  for (const Entry& entry : entries) {
    if (entry.isArgument != ofArguments) continue;
    const std::string value = entry.value.empty() ? "" : " " + entry.value;
    text += beside("  " + entry.names + value, entry.text, kTextColumn);
  }
  return text.empty() ? "" : "\n" + title + "\n" + text;
}

std::string row(std::initializer_list<std::string> fields) {
  std::string line;
  for (const std::string& field : fields) {
    line += (line.empty() ? "" : "\t") + (field.empty() ? std::string("-") : field);
  }
  std::ranges::replace(line, '\n', ' ');
  return line + "\n";
}

}  // namespace

std::string helpText(CLI::App& app) {
  const std::vector<Entry> entries = makeEntries(app);
  return beside("", sentence(app.get_description()), 0) + beside("Usage: " + app.get_name(), usage(app), 0) +
         section("Arguments:", entries, true) + section("Options:", entries, false) + "\n" +
         beside("", app.get_footer(), 0);
}

std::string helpTable(CLI::App& app) {
  std::string table = row({"program", app.get_name()}) + row({"purpose", sentence(app.get_description())}) +
                      row({"usage", usage(app)});
  for (const Entry& entry : makeEntries(app)) {
    table +=
        row({entry.isArgument ? "argument" : "option", entry.names, entry.value, entry.allowed, entry.text});
  }
  return table + row({"footer", app.get_footer()});
}

}  // namespace lavaray
