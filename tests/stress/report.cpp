#include "stress/report.hpp"

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string_view>

#include <gtest/gtest.h>

namespace lavaray {

bool isFullSize() {
  const char* size = std::getenv("LAVARAY_STRESS");
  return size != nullptr && std::string_view(size) == "full";
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t end = digits.size(); end > 3; end -= 3) digits.insert(end - 3, ",");
  return digits;
}

std::string shortNumber(double number) {
  std::ostringstream text;
  text.precision(3);
  text << number;
  return text.str();
}

void report(const std::string& figure) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const char* device = std::getenv("LAVARAY_TEST_DEVICE");
  std::cout << "figure: " << (device != nullptr ? std::string(device) + ": " : "") << test->test_suite_name()
            << '.' << test->name() << ": " << figure << std::endl;
}

}  // namespace lavaray
