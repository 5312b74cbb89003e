#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "lavaray/run_report.hpp"

namespace lavaray {

void printWarnings(std::ostream& out, const std::vector<std::string>& warnings);

void printDevices(std::ostream& out, const std::vector<DeviceInfo>& devices);

// What --check says.
void printScene(std::ostream& out, const SceneSummary& scene);

// What --stats says.
void printReport(std::ostream& out, const RunReport& report);

}  // namespace lavaray
