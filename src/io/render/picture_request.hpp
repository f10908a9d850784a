// What a picture is to show, with every default filled in.
#pragma once

#include "cleft/cleft_io.h"
#include "io/vector3.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cleft::io
{

struct PictureRequest {
    cleft_io_colouring by = CLEFT_IO_BY_LABEL;
    int width = 0, height = 0;
    cleft_io_backdrop backdrop = CLEFT_IO_BACKDROP_LIGHT;
    bool has_edges = true;
    bool has_legend = false;
    Vector3 cut{};     // shares of the box, 0 along an axis without a cut
    Vector3 to_eye{};  // of length 1
    Vector3 up{};
    double zoom = 1;
    double line_width = 1;          // in pixels
    std::array<double, 2> range{};  // of the colours; both 0: of the measure
    std::vector<int32_t> strip, whole;

    bool leaves_out(int32_t label) const { return std::find(strip.begin(), strip.end(), label) != strip.end(); }
    bool keeps_whole(int32_t label) const { return std::find(whole.begin(), whole.end(), label) != whole.end(); }
    bool is_cut() const { return cut[0] > 0 || cut[1] > 0 || cut[2] > 0; }
};

// The lists are those of cleft_io_write_picture(). Throws Error with the name and the value of a field that cannot be.
PictureRequest checked_request(const cleft_io_picture& given, std::vector<int32_t> strip, std::vector<int32_t> whole);

}  // namespace cleft::io
