// Sample positions: Owen-scrambled Sobol points or independent random numbers. They are a pure function of
// sequence, sample and use, so that any sample can be taken anywhere and at any time.
#ifndef RANDOM_GLSL
#define RANDOM_GLSL

#include "interface.h"

layout(constant_id = kSpecSampling) const uint kSampling = kSamplingCenter;

// Mixes 32 bits. Based on: Wang and Mueller's "Hash Prospector" search, 2018 (the function lowbias32).
uint hash(uint x) {
  x ^= x >> 16;
  x *= 0x7FEB352Du;
  x ^= x >> 15;
  x *= 0x846CA68Bu;
  return x ^ (x >> 16);
}

uint hashCombine(uint seed, uint value) {
  return hash(seed ^ hash(value + 0x9E3779B9u));
}

// Owen's nested uniform scrambling of an x with reversed bits: the bits that were above a bit decide whether
// it is flipped. Based on: Laine and Karras, "Stratified Sampling for Stochastic Transparency", 2011, with
// the constants of Vegdahl, "Building a Better LK Hash", 2021.
uint scrambleReversed(uint x, uint seed) {
  x ^= x * 0x3D20ADEAu;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526C56u;
  x ^= x * 0x53A22864u;
  return x;
}

uint scramble(uint x, uint seed) {
  return bitfieldReverse(scrambleReversed(bitfieldReverse(x), seed));
}

// The second Sobol dimension at an index. Its generator matrix is Pascal's triangle modulo 2: row i has a 1
// in column j where the bits of i are among those of j. So the product takes five steps, one for each bit of
// a bit's number.
uint sobolSecond(uint index) {
  index ^= (index & 0xAAAAAAAAu) >> 1;
  index ^= (index & 0xCCCCCCCCu) >> 2;
  index ^= (index & 0xF0F0F0F0u) >> 4;
  index ^= (index & 0xFF00FF00u) >> 8;
  index ^= index >> 16;
  return bitfieldReverse(index);
}

// The upper 24 bits as a number in [0, 1).
float unitInterval(uint x) {
  return float(x >> 8) * 5.9604645e-8;
}

// The shuffled index of a sample in a sequence: for every power of two n, the first n indices are permuted
// among themselves. A sequence's seed gives it a shuffle and values of its own, so it is independent of other
// sequences.
uint shuffledIndex(uint index, uint seed) {
  return kSampling == kSamplingRandom ? index : scramble(index, seed);
}

// The point at an index of a sequence in [0, 1)^2, whose first n points are a (0, 2)-net for every power of
// two n. Based on: Burley, "Practical Hash-based Owen Scrambling", 2020.
vec2 pairAt(uint index, uint seed) {
  if (kSampling == kSamplingRandom) {
    const uint random = hashCombine(seed, index);
    return vec2(unitInterval(random), unitInterval(hash(random ^ 0x68BC21EBu)));
  }
  const uint x = bitfieldReverse(scrambleReversed(index, hashCombine(seed, 1u)));
  const uint y = scramble(sobolSecond(index), hashCombine(seed, 2u));
  return vec2(unitInterval(x), unitInterval(y));
}

// A sequence has this many companions. Each is a (0, 2)-sequence with a seed of its own and, together with
// the sequence, is stratified in four dimensions, as two independent sequences are not. A companion's index
// is the sequence's index times a factor of six terms, both taken as polynomials over the field of two
// elements, highest bit first; what falls below the lowest bit is dropped. The first term is 1. For each
// other term the table has the bits by which it shifts down, one hexadecimal digit per companion, that of
// companion 0 the lowest.
//
// Any factors would do. A search found these to leave the least variance in penumbrae 0.7 to 33 pixels wide
// at 4 to 65,536 samples, by the gain coefficients of scrambled nets (Pan and Owen, "The Nonzero Gain
// Coefficients of Sobol's Sequences Are Always Powers of Two", 2023): in narrow ones as little as four Sobol
// dimensions leave, in wide ones as little as two.
const uint kCompanions = 16u;
const uint kCompanionTerms = 5u;
const uvec2 kCompanionShifts[kCompanionTerms] =
    uvec2[](uvec2(0x23312131u, 0x31421411u), uvec2(0x34733352u, 0x44544622u), uvec2(0x85844765u, 0x85657736u),
            uvec2(0xB9B68998u, 0xC7969D58u), uvec2(0xFBC9FBCAu, 0xFEABCE9Eu));

uint companionIndex(uint index, uint companion) {
  uint product = index;
  [[unroll]] for (uint i = 0u; i < kCompanionTerms; ++i) {
    product ^= index >> (kCompanionShifts[i][companion / 8u] >> 4u * (companion % 8u) & 15u);
  }
  return product;
}

#endif
