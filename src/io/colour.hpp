// A colour of a picture, and mixtures of two.
#pragma once

#include <cstdint>

namespace cleft::io
{

// Red, green and blue of sRGB.
struct Colour {
    uint8_t red = 0, green = 0, blue = 0;

    constexpr bool operator==(const Colour& other) const
    {
        return red == other.red && green == other.green && blue == other.blue;
    }
};

// Shares of a mixture are counted in parts of 256: whole numbers give the same colour on every machine.
constexpr int kWhole = 256;

constexpr uint8_t mixed(uint8_t a, uint8_t b, int share_of_b)
{
    return static_cast<uint8_t>((a * (kWhole - share_of_b) + b * share_of_b + kWhole / 2) / kWhole);
}

constexpr Colour mixed(Colour a, Colour b, int share_of_b)
{
    return {mixed(a.red, b.red, share_of_b), mixed(a.green, b.green, share_of_b), mixed(a.blue, b.blue, share_of_b)};
}

constexpr Colour kWhite{255, 255, 255};
constexpr Colour kBlack{0, 0, 0};

}  // namespace cleft::io
