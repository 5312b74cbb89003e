#pragma once

namespace lavaray {

// From here on no temporary file outlives the process, whatever signal ends it but SIGKILL, and whoever calls
// exit(), a driver included. What is said of the signal stays: a core is dumped where one would have been. A
// write to a pipe that nobody reads is an error, and not the end of a render that only lost its listener.
void cleanUpAtDeath();

}  // namespace lavaray
