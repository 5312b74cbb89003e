#pragma once

#include <string>

namespace lavaray {

// From here on a limit on the size of files (`ulimit -f`) ends the program with a message, not by a signal.
// Writing beyond it is an error. Memory beyond it ends the process with ErrorKind::kMemory and a message that
// begins with `programName`, and leaves no temporary file.
//
// The limit applies to memory if a driver that renders on the CPU keeps it in a nameless file (memfd_create),
// as Mesa 25's does. That driver does not notice if the file cannot grow, so the first access beyond its end
// raises SIGBUS, in any thread, even one of the driver's own.
void surviveFileSizeLimit(const std::string& programName);

}  // namespace lavaray
