#ifndef SWIVEL_TMP_REG
#define SWIVEL_TMP_REG
#include "kernels/registers/ops.hpp"
#include "kernels/registers/twin.hpp"
namespace swivel { namespace {
#if defined(__AVX512F__)
using architecture = xsimd::avx512bw;
#elif defined(__AVX2__)
using architecture = xsimd::fma3<xsimd::avx2>;
#else
using architecture = xsimd::sse2;
#endif
template <class V> struct is_twin { static constexpr bool value=false; };
template <class V> struct is_twin<twin<V>> { static constexpr bool value=true; using half=V; };
template <class W> requires(is_twin<W>::value) inline W load_first(const typename W::value_type* from, std::size_t count) noexcept {
  using V=typename is_twin<W>::half;
  const V first(*from);
  if (count <= V::size) return {count==V::size?V::load_unaligned(from):load_first<V>(from,count), first};
  return {V::load_unaligned(from), load_first<V>(from+V::size,count-V::size)};
}
template <class V> inline void store_first(const twin<V>& a, typename V::value_type* to, std::size_t count) noexcept {
  if (count<V::size) return store_first(a.first,to,count);
  a.first.store_unaligned(to);
  if (count>V::size) store_first(a.second,to+V::size,count-V::size);
}
}}
#endif
