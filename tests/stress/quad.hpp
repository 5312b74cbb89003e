#pragma once

namespace lavaray {

// IEEE binary128: 113 bits of mantissa, in the compiler's own software arithmetic. Sums and products of a few
// floats of about the same size are exact in it, which is what the oracles here rely on.
__extension__ typedef __float128 Quad;

}  // namespace lavaray
