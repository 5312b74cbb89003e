#pragma once

namespace lavaray {

// Every number in a scene or mesh must be within +-kMaxMagnitude: the shaders compute in float32, where
// squares and products of larger coordinates overflow.
inline constexpr double kMaxMagnitude = 1e15;

// Longest side of an image, in pixels.
inline constexpr int kMaxImageSide = 65535;

// Corners of a mesh's face. Ear clipping takes time up to the square of this.
inline constexpr int kMaxFaceCorners = 16384;

}  // namespace lavaray
