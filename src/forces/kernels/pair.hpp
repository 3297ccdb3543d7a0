// Both components of a vector field, for one register of blocks.
#pragma once

#include "lanes.hpp"
#include "rupture/forces/kernels.hpp"

namespace rupture {
namespace {

struct Pair {
  Lanes x, z;
};

inline Pair operator+(Pair a, Pair b) {
  return {a.x + b.x, a.z + b.z};
}
inline Pair operator-(Pair a, Pair b) {
  return {a.x - b.x, a.z - b.z};
}
inline Pair operator*(Lanes a, Pair b) {
  return {a * b.x, a * b.z};
}
inline Pair operator*(double a, Pair b) {
  return {a * b.x, a * b.z};
}

inline Pair shifted_up(Pair before, Pair now) {
  return {shifted_up(before.x, now.x), shifted_up(before.z, now.z)};
}
inline Pair shifted_down(Pair now, Pair after) {
  return {shifted_down(now.x, after.x), shifted_down(now.z, after.z)};
}

inline ConstVectorView constant(VectorView v) {
  return {v.x, v.z};
}

inline VectorView row_of(const LatticeShape& n, VectorView v, Index j) {
  return {v.x + j * n.stride, v.z + j * n.stride};
}
inline ConstVectorView row_of(const LatticeShape& n, ConstVectorView v, Index j) {
  return {v.x + j * n.stride, v.z + j * n.stride};
}

inline Pair load(ConstVectorView from, Index i) {
  return {load(from.x + i), load(from.z + i)};
}
inline Pair load(VectorView from, Index i) {
  return load(constant(from), i);
}
inline void store(VectorView to, Index i, Pair value) {
  store(to.x + i, value.x);
  store(to.z + i, value.z);
}

}  // namespace
}  // namespace rupture
