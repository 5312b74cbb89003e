#pragma once

#include <string>

namespace lavaray {

// Blocks of a scene file; append kMaterial to those that need a material.
inline const std::string kCamera = "camera\npos: 0 0 0\nfov: 60\nf: 100\na: 1.5\n";  // 5 lines
inline const std::string kMaterial = "amb: 0.1 0.2 0.3\ndif: 0.4 0.5 0.6\nspe: 0.7 0.8 0.9\nshi: 10\n";
inline const std::string kSphere = "sphere\npos: 1 2 3\nrad: 4\n" + kMaterial;  // 7 lines
inline const std::string kLight = "light\npos: 1 2 3\namb: 0.1 0.1 0.1\ndif: 0.2 0.2 0.2\nspe: 0.3 0.3 0.3\n";
inline const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace lavaray
