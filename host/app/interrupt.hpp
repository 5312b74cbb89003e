#pragma once

#include <atomic>

namespace lavaray {

// From now on SIGINT and SIGTERM set the returned flag, which a render looks at between its pieces; a second
// one ends the process at once.
const std::atomic<bool>& catchInterrupts();

}  // namespace lavaray
