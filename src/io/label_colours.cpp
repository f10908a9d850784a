// The palette of labels: seven hues, each plain, lighter and darker.
#include "io/label_colours.hpp"

namespace cleft::io
{

namespace
{

constexpr Colour kOutside{212, 214, 218};

// The hues of Okabe and Ito ("Color Universal Design", 2008), which people with any kind of colour blindness tell
// apart. The order is ours: warm and cool ones, light and dark ones by turns.
constexpr Colour kHues[] = {{86, 180, 233}, {230, 159, 0},  {0, 158, 115}, {204, 121, 167},
                            {0, 114, 178},  {240, 228, 66}, {213, 94, 0}};
constexpr uint32_t kHueCount = sizeof kHues / sizeof *kHues;

// So much lighter and darker that a face in shade is not taken for the next variant.
constexpr int kLighter = kWhole * 45 / 100;
constexpr int kDarker = kWhole * 25 / 100;

}  // namespace

Colour colour_of_label(int32_t label)
{
    if (label == 0)
        return kOutside;
    // The absolute value as unsigned, which -2^31 has too.
    const uint32_t number = (label < 0 ? 0U - static_cast<uint32_t>(label) : static_cast<uint32_t>(label)) - 1;
    const Colour hue = kHues[number % kHueCount];
    switch (number / kHueCount % 3) {
        case 1:
            return mixed(hue, kWhite, kLighter);
        case 2:
            return mixed(hue, kBlack, kDarker);
        default:
            return hue;
    }
}

}  // namespace cleft::io
