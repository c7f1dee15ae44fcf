// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Storing some lanes of a vector one after the other. Included once per instruction
// set, so it has a guard that toggles.

#if defined(LINELET_APPEND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_APPEND_INL
#undef LINELET_APPEND_INL
#else
#define LINELET_APPEND_INL
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace linelet {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET <= HWY_AVX3

template <class Tag, class Vector, class Mask>
HWY_INLINE Vector
packed(Tag, Vector vector, Mask mask)
{
  return hn::Compress(vector, mask);
}

#else

// Without an instruction for it, a table says for each mask where lanes come from.
// Highway's own are copied to the stack at each use by some compilers.

/** \brief An entry per mask: \a size bytes for each of its lanes, then for the others.
 */
template <std::size_t lanes, std::size_t size>
constexpr std::array<std::array<std::uint8_t, lanes * size>, 1U << lanes>
packingTable()
{
  std::array<std::array<std::uint8_t, lanes * size>, 1U << lanes> table{};
  for (std::size_t mask = 0; mask < table.size(); ++mask) {
    std::size_t next = 0;
    for (const std::size_t wanted : {std::size_t{1}, std::size_t{0}})
      for (std::size_t lane = 0; lane < lanes; ++lane)
        if ((mask >> lane & 1) == wanted)
          for (std::size_t byte = 0; byte < size; ++byte)
            table[mask][next++] = static_cast<std::uint8_t>(lane * size + byte);
  }
  return table;
}

alignas(16) constexpr auto bytes_of_four = packingTable<4, 4>();
alignas(16) constexpr auto lanes_of_eight = packingTable<8, 1>();

/** \brief The lanes of \a mask, of 32 bits each, before the others. */
template <class Tag, class Vector, class Mask>
HWY_INLINE Vector
packed(Tag tag, Vector vector, Mask mask)
{
  std::array<std::uint8_t, 8> bits{};
  hn::StoreMaskBits(tag, mask, bits.data());
  if constexpr (hn::MaxLanes(Tag()) == 8) {
    const hn::RebindToUnsigned<Tag> u;
    const hn::Rebind<std::uint8_t, Tag> bytes;
    const auto lanes =
        hn::PromoteTo(u, hn::Load(bytes, lanes_of_eight[bits[0]].data()));
    return hn::TableLookupLanes(vector, hn::IndicesFromVec(tag, lanes));
  }
  else {
    const hn::Repartition<std::uint8_t, Tag> bytes;
    const auto from = hn::Load(bytes, bytes_of_four[bits[0]].data());
    return hn::BitCast(tag, hn::TableLookupBytes(hn::BitCast(bytes, vector), from));
  }
}

#endif

/** \brief Stores the lanes of \a mask, of 32 bits each, one after the other; a whole
 * vector is written. (Packing in a register is fast everywhere, packing into memory is
 * not.) */
template <class Tag, class Vector, class Mask>
HWY_INLINE void
append(Tag tag, Vector vector, Mask mask, hn::TFromD<Tag>* at)
{
  hn::StoreU(packed(tag, vector, mask), tag, at);
}

/** \brief The same for lanes of 64 bits. */
template <class Tag, class Vector, class Mask>
HWY_INLINE void
appendWide(Tag tag, Vector vector, Mask mask, hn::TFromD<Tag>* at)
{
#if HWY_TARGET == HWY_SCALAR
  append(tag, vector, mask, at);
#else
  const hn::Repartition<std::uint32_t, Tag> halves;
  const auto both = hn::MaskFromVec(hn::BitCast(halves, hn::VecFromMask(tag, mask)));
  const auto pairs = packed(halves, hn::BitCast(halves, vector), both);
  hn::StoreU(hn::BitCast(tag, pairs), tag, at);
#endif
}

} // namespace HWY_NAMESPACE
} // namespace linelet
HWY_AFTER_NAMESPACE();

#endif
