#pragma once

namespace lavaray {

// Numbers of a scene or a mesh must be within +-kMaxMagnitude: the shader works in float32, where the squares
// and products of larger coordinates overflow.
inline constexpr double kMaxMagnitude = 1e15;

// Longest side of an image, in pixels.
inline constexpr int kMaxImageSide = 65535;

// Corners of a mesh's face. Ear clipping takes up to the square of them.
inline constexpr int kMaxFaceCorners = 16384;

}  // namespace lavaray
