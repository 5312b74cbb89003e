#include "render/render_statistics.hpp"

namespace lavaray {

const char* stopReasonName(StopReason reason) {
  switch (reason) {
    case StopReason::kMaxSamples:
      return "maxSamples";
    case StopReason::kTimeLimit:
      return "timeLimit";
    case StopReason::kInterrupted:
      return "interrupted";
    case StopReason::kFinished:
      break;
  }
  return "finished";
}

}  // namespace lavaray
