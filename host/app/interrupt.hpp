#pragma once

namespace lavaray {

// From now on SIGINT and SIGTERM are remembered, which a render looks at between its pieces; a second one
// ends the process at once.
void catchInterrupts();
bool wasInterrupted();

}  // namespace lavaray
