// What programs of microscopy write into the description of a TIFF file about its pages.
#pragma once

#include "io/vector3.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

// What the tags of a page say of its size.
struct TiffPageSize {
    int64_t width = 0;
    int64_t height = 0;
    double x_resolution = 0;  // pixels per unit; 0: not there
    double y_resolution = 0;
    unsigned unit = 2;  // of ResolutionUnit: 1 none, 2 inch, 3 centimetre
};

// What was found. Lengths are in `unit`, and are not converted.
struct TiffDescription {
    std::string who;     // the program; "": the text is none that is known
    int64_t slices = 0;  // how many it speaks of; 0: it does not say
    bool has_spacing = false;
    Vector3 spacing{1, 1, 1};
    bool knows_third = false;  // does it give the distance between slices?
    std::string unit;          // of the spacing; "": not said
    std::vector<std::string> notes;
};

// ImageJ's text, OME's XML, tifffile's shape, or none of them. Throws, by name, where the pages are channels or points
// in time, several images, or slices in another order. Errors do not name the file.
TiffDescription tiff_description(const std::string& text, const TiffPageSize& page);

// Of a unit of length, in the letters of ASCII: "um" for all that mean it.
std::string plain_unit(const std::string& unit);

}  // namespace cleft::io
