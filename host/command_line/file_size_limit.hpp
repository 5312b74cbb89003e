#pragma once

#include <string>

namespace lavaray {

// A limit on the size of files (`ulimit -f`) is to end a program with a message, not by a signal. A write
// beyond it is an error from here on. Memory beyond it ends the process with ExitCode::kMemory, the message
// begins with `programName`, and no temporary file stays.
//
// Memory counts where a driver that renders on the CPU keeps it in a file without a name (memfd_create), as
// Mesa 25's does. It takes no notice where the file cannot grow, so that the first access to what is not
// there raises SIGBUS, in any thread, the driver's own among them.
void surviveFileSizeLimit(const std::string& programName);

}  // namespace lavaray
