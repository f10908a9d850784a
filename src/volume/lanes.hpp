// Many voxels at once. Sampling a label map spends its time in these few operations, and compilers do not find the
// instructions for them by themselves. Both versions do the same operations in the same order and give the same bytes.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace cleft
{

constexpr int kLanes = 8;   // of a row of weights
constexpr int kChunk = 16;  // voxels that are compared at once

#if defined(__SSE2__)

// Eight floats.
struct FloatRow {
    __m128 low, high;

    static FloatRow load(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
    void store(float* p) const
    {
        _mm_storeu_ps(p, low);
        _mm_storeu_ps(p + 4, high);
    }
    FloatRow operator+(FloatRow o) const { return {_mm_add_ps(low, o.low), _mm_add_ps(high, o.high)}; }
    FloatRow operator*(float factor) const
    {
        const __m128 f = _mm_set1_ps(factor);
        return {_mm_mul_ps(low, f), _mm_mul_ps(high, f)};
    }
};

// Sixteen bytes.
struct ByteChunk {
    __m128i bits;

    static ByteChunk load(const uint8_t* p) { return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))}; }
    void store(uint8_t* p) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), bits); }
    // All bits of the lanes in which p holds `value`.
    static ByteChunk equal(const uint8_t* p, uint8_t value)
    {
        return {_mm_cmpeq_epi8(load(p).bits, _mm_set1_epi8(static_cast<char>(value)))};
    }
    static ByteChunk equal(const uint16_t* p, uint16_t value)
    {
        const __m128i v = _mm_set1_epi16(static_cast<short>(value));
        const auto* q = reinterpret_cast<const __m128i*>(p);
        return {_mm_packs_epi16(_mm_cmpeq_epi16(_mm_loadu_si128(q), v), _mm_cmpeq_epi16(_mm_loadu_si128(q + 1), v))};
    }
    ByteChunk operator&(ByteChunk o) const { return {_mm_and_si128(bits, o.bits)}; }
    ByteChunk operator|(ByteChunk o) const { return {_mm_or_si128(bits, o.bits)}; }
    ByteChunk without(ByteChunk o) const { return {_mm_andnot_si128(o.bits, bits)}; }
    // Bit i is the top bit of lane i.
    unsigned mask() const { return static_cast<unsigned>(_mm_movemask_epi8(bits)); }
    bool all_zero() const { return _mm_movemask_epi8(_mm_cmpeq_epi8(bits, _mm_setzero_si128())) == 0xffff; }
};

// Sixteen bytes as floats.
struct FloatChunk {
    __m128 part[4];

    explicit FloatChunk(ByteChunk bytes)
    {
        const __m128i zero = _mm_setzero_si128();
        const __m128i low = _mm_unpacklo_epi8(bytes.bits, zero), high = _mm_unpackhi_epi8(bytes.bits, zero);
        part[0] = _mm_cvtepi32_ps(_mm_unpacklo_epi16(low, zero));
        part[1] = _mm_cvtepi32_ps(_mm_unpackhi_epi16(low, zero));
        part[2] = _mm_cvtepi32_ps(_mm_unpacklo_epi16(high, zero));
        part[3] = _mm_cvtepi32_ps(_mm_unpackhi_epi16(high, zero));
    }
};

// A sum of products in four lanes. Factors are aligned to 16 bytes.
// Sums of floats depend on their order: four products are added crosswise first, then to the lanes, in both versions.
struct ChunkSum {
    __m128 lanes = _mm_setzero_ps();

    void add(const FloatChunk& a, const float* factor)
    {
        const __m128 p0 = _mm_mul_ps(a.part[0], _mm_load_ps(factor));
        const __m128 p1 = _mm_mul_ps(a.part[1], _mm_load_ps(factor + 4));
        const __m128 p2 = _mm_mul_ps(a.part[2], _mm_load_ps(factor + 8));
        const __m128 p3 = _mm_mul_ps(a.part[3], _mm_load_ps(factor + 12));
        lanes = _mm_add_ps(lanes, _mm_add_ps(_mm_add_ps(p0, p1), _mm_add_ps(p2, p3)));
    }
    float total() const
    {
        const __m128 two = _mm_add_ps(lanes, _mm_movehl_ps(lanes, lanes));
        return _mm_cvtss_f32(_mm_add_ss(two, _mm_shuffle_ps(two, two, 1)));
    }
};

// Sums of the first eight lanes of bytes.
// A sum must stay within 16 bits; label_feedback.cpp says why its own does.
struct WordSum {
    __m128i words = _mm_setzero_si128();

    // Adds factor * (plus - minus).
    void add(int factor, ByteChunk plus, ByteChunk minus)
    {
        const __m128i zero = _mm_setzero_si128();
        const __m128i difference =
            _mm_sub_epi16(_mm_unpacklo_epi8(plus.bits, zero), _mm_unpacklo_epi8(minus.bits, zero));
        words = _mm_add_epi16(words, _mm_mullo_epi16(_mm_set1_epi16(static_cast<short>(factor)), difference));
    }
    void store(int16_t* p) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), words); }
};

// The same operations for other processors. Compilers may vectorize these loops, but not reorder their sums.
#else

struct FloatRow {
    float lanes[kLanes];

    static FloatRow load(const float* p)
    {
        FloatRow out;
        std::memcpy(out.lanes, p, sizeof(out.lanes));
        return out;
    }
    void store(float* p) const { std::memcpy(p, lanes, sizeof(lanes)); }
    FloatRow operator+(FloatRow o) const
    {
        for (int i = 0; i < kLanes; ++i)
            o.lanes[i] += lanes[i];
        return o;
    }
    FloatRow operator*(float factor) const
    {
        FloatRow out;
        for (int i = 0; i < kLanes; ++i)
            out.lanes[i] = lanes[i] * factor;
        return out;
    }
};

struct ByteChunk {
    uint8_t bytes[kChunk];

    static ByteChunk load(const uint8_t* p)
    {
        ByteChunk out;
        std::memcpy(out.bytes, p, kChunk);
        return out;
    }
    void store(uint8_t* p) const { std::memcpy(p, bytes, kChunk); }
    template <class Label>
    static ByteChunk equal(const Label* p, Label value)
    {
        ByteChunk out;
        for (int i = 0; i < kChunk; ++i)
            out.bytes[i] = p[i] == value ? 0xff : 0;
        return out;
    }
    ByteChunk operator&(ByteChunk o) const
    {
        for (int i = 0; i < kChunk; ++i)
            o.bytes[i] = static_cast<uint8_t>(bytes[i] & o.bytes[i]);
        return o;
    }
    ByteChunk operator|(ByteChunk o) const
    {
        for (int i = 0; i < kChunk; ++i)
            o.bytes[i] = static_cast<uint8_t>(bytes[i] | o.bytes[i]);
        return o;
    }
    ByteChunk without(ByteChunk o) const
    {
        for (int i = 0; i < kChunk; ++i)
            o.bytes[i] = static_cast<uint8_t>(bytes[i] & ~o.bytes[i]);
        return o;
    }
    unsigned mask() const
    {
        unsigned out = 0;
        for (int i = 0; i < kChunk; ++i)
            out |= static_cast<unsigned>(bytes[i] >> 7) << i;
        return out;
    }
    bool all_zero() const
    {
        uint8_t any = 0;
        for (int i = 0; i < kChunk; ++i)
            any = static_cast<uint8_t>(any | bytes[i]);
        return any == 0;
    }
};

struct FloatChunk {
    float part[4][4];

    explicit FloatChunk(ByteChunk bytes)
    {
        for (int i = 0; i < kChunk; ++i)
            part[i / 4][i % 4] = bytes.bytes[i];
    }
};

struct ChunkSum {
    float lanes[4] = {};

    void add(const FloatChunk& a, const float* factor)
    {
        for (int i = 0; i < 4; ++i)
            lanes[i] += (a.part[0][i] * factor[i] + a.part[1][i] * factor[i + 4]) +
                        (a.part[2][i] * factor[i + 8] + a.part[3][i] * factor[i + 12]);
    }
    float total() const { return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]); }
};

struct WordSum {
    int16_t words[kLanes] = {};

    void add(int factor, ByteChunk plus, ByteChunk minus)
    {
        for (int i = 0; i < kLanes; ++i)
            words[i] = static_cast<int16_t>(words[i] + factor * (plus.bytes[i] - minus.bytes[i]));
    }
    void store(int16_t* p) const { std::memcpy(p, words, sizeof(words)); }
};

#endif

// The place of the lowest bit that is set, of at least one.
inline int lowest_bit(unsigned bits)
{
#if defined(__GNUC__)
    return __builtin_ctz(bits);
#else
    int place = 0;
    for (; !(bits & 1); bits >>= 1)
        ++place;
    return place;
#endif
}

}  // namespace cleft
