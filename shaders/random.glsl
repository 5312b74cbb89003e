// Sample positions: Owen-scrambled Sobol points or independent random numbers, a pure function of sequence,
// sample and use, so that any sample can be taken anywhere and at any time.
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

uint hashCombine(uint seed, uint value) { return hash(seed ^ hash(value + 0x9E3779B9u)); }

// Owen's nested uniform scrambling of x whose bits are reversed: a bit is flipped as the ones that were above
// it say. Based on: Laine and Karras, "Stratified Sampling for Stochastic Transparency", 2011, with the
// constants of Vegdahl, "Building a Better LK Hash", 2021.
uint scrambleReversed(uint x, uint seed) {
  x ^= x * 0x3D20ADEAu;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526C56u;
  x ^= x * 0x53A22864u;
  return x;
}

uint scramble(uint x, uint seed) { return bitfieldReverse(scrambleReversed(bitfieldReverse(x), seed)); }

// The second Sobol dimension of an index. Its generator matrix is Pascal's triangle modulo 2, whose entry (i, j)
// is 1 where the bits of i are among those of j: so the product is five steps, one for each bit of the bit
// numbers.
uint sobolSecond(uint index) {
  index ^= (index & 0xAAAAAAAAu) >> 1;
  index ^= (index & 0xCCCCCCCCu) >> 2;
  index ^= (index & 0xF0F0F0F0u) >> 4;
  index ^= (index & 0xFF00FF00u) >> 8;
  index ^= index >> 16;
  return bitfieldReverse(index);
}

// The upper 24 bits as a number in [0, 1).
float unitInterval(uint x) { return float(x >> 8) * 5.9604645e-8; }

// Sample `index` of a two-dimensional sequence in [0, 1)^2. Every power of two samples from 0 on is a (0, 2)-net;
// sequences with different seeds are independent: their indices are shuffled and their values scrambled.
// Based on: Burley, "Practical Hash-based Owen Scrambling", 2020.
vec2 samplePair(uint index, uint seed) {
  if (kSampling == kSamplingRandom) {
    const uint random = hashCombine(seed, index);
    return vec2(unitInterval(random), unitInterval(hash(random ^ 0x68BC21EBu)));
  }
  const uint shuffled = scramble(index, seed);
  const uint x = bitfieldReverse(scrambleReversed(shuffled, hashCombine(seed, 1u)));
  const uint y = scramble(sobolSecond(shuffled), hashCombine(seed, 2u));
  return vec2(unitInterval(x), unitInterval(y));
}

#endif
