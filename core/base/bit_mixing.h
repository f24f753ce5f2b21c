// Hashes of 32 bits and the scrambled Sobol' sequence, for one number (`Bits` is std::uint32_t: sampling.h)
// or for several at once (BitLanes: bit_lanes.h, which includes this for each instruction set anew).

namespace mixing {

/// Bijective (C. Wellons 2018, hash "lowbias32").
template <class Bits>
[[gnu::always_inline]] constexpr Bits hash(Bits v) {
    v = v ^ (v >> 16U);
    v = v * Bits(0x7feb352dU);
    v = v ^ (v >> 15U);
    v = v * Bits(0x846ca68bU);
    return v ^ (v >> 16U);
}

template <class Bits>
[[gnu::always_inline]] constexpr Bits combine(Bits a, Bits b) {
    return hash(a ^ (hash(b) + Bits(0x9e3779b9U) + (a << 6U) + (a >> 2U)));
}

template <class Bits>
[[gnu::always_inline]] constexpr Bits reversed(Bits v) {
    v = (v << 16U) | (v >> 16U);
    v = ((v & Bits(0x00ff00ffU)) << 8U) | ((v & Bits(0xff00ff00U)) >> 8U);
    v = ((v & Bits(0x0f0f0f0fU)) << 4U) | ((v & Bits(0xf0f0f0f0U)) >> 4U);
    v = ((v & Bits(0x33333333U)) << 2U) | ((v & Bits(0xccccccccU)) >> 2U);
    return ((v & Bits(0x55555555U)) << 1U) | ((v & Bits(0xaaaaaaaaU)) >> 1U);
}

/// Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 10(4), section 2.4, with N. Vegdahl's constants
/// (2021, "Building a Better LK Hash").
template <class Bits>
[[gnu::always_inline]] constexpr Bits laineKarrasPermutation(Bits v, Bits seed) {
    v = v ^ (v * Bits(0x3d20adeaU));
    v = v + seed;
    v = v * ((seed >> 16U) | Bits(1U));
    v = v ^ (v * Bits(0x05526c56U));
    return v ^ (v * Bits(0x53a22864U));
}

/// Second Sobol' dimension, its bits in reverse. Its direction numbers are the rows of Pascal's triangle
/// modulo 2, in which bit j of row i is set where j's bits are among i's: so each bit becomes the sum of
/// those whose numbers contain its own, which five halvings add up.
template <class Bits>
[[gnu::always_inline]] constexpr Bits sobolSecondDimensionReversed(Bits index) {
    index = index ^ ((index >> 1U) & Bits(0x55555555U));
    index = index ^ ((index >> 2U) & Bits(0x33333333U));
    index = index ^ ((index >> 4U) & Bits(0x0f0f0f0fU));
    index = index ^ ((index >> 8U) & Bits(0x00ff00ffU));
    return index ^ (index >> 16U);
}

template <class Bits>
struct Point {
    Bits x, y;
};

/// Scrambling begins by reversing the bits, as the first dimension does: twice is not at all. So it takes a
/// coordinate with its bits in reverse.
template <class Bits>
[[gnu::always_inline]] constexpr Bits scrambled(Bits reversedBits, Bits key, Bits axis) {
    return reversed(laineKarrasPermutation(reversedBits, combine(key, axis)));
}

/// Point number `pass` of the Owen-scrambled Sobol' (0,2)-sequence of a key, in units of 2⁻³².
template <class Bits>
[[gnu::always_inline]] constexpr Point<Bits> sobol(Bits pass, Bits key) {
    const Bits index = reversed(laineKarrasPermutation(reversed(pass), key));
    return {scrambled(index, key, Bits(1U)), scrambled(sobolSecondDimensionReversed(index), key, Bits(2U))};
}

/// The key of a sequence: all that addresses a number but which sample it is for.
template <class Bits>
[[gnu::always_inline]] constexpr Bits keyOf(Bits seed, Bits x, Bits y, Bits node, Bits purpose) {
    return combine(combine(combine(combine(seed, x), y), node), purpose);
}

}
