// Takes the place of embree_peer.cpp if the program is built without Embree.
#include "peer.hpp"

namespace lavaray::bench {

std::string embreeDescription() {
  return "missing: this program was built without Embree (Debian's libembree-dev)";
}

std::unique_ptr<Peer> openEmbree(const Scene&, unsigned) {
  return nullptr;
}

}  // namespace lavaray::bench
