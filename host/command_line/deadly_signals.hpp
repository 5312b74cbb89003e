#pragma once

namespace lavaray {

// From here on no temporary file outlives the process, whichever signal except SIGKILL ends it, and whoever
// calls exit(), even a driver. The signal keeps its effect: if a core would have been dumped, it still is.
// Writing to a pipe that nobody reads is an error, and no longer ends a render that has merely lost its
// reader.
void cleanUpAtDeath();

}  // namespace lavaray
