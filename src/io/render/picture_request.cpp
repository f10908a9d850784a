// Checks what a caller asks of a picture, and fills in the defaults.
#include "io/render/picture_request.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace cleft::io
{

namespace
{

constexpr int32_t kDefaultWidth = 1200;
constexpr int32_t kDefaultHeight = 900;
constexpr double kGreatestZoom = 50;        // with kGreatestSide, places on the picture fit 32 bits: see camera.cpp
constexpr int32_t kGreatestSide = 8192;     // 8 bytes a pixel make half a gigabyte
constexpr double kGreatestLineWidth = 100;  // pixels; beyond it nothing is left of the faces
constexpr Vector3 kDefaultToEye{-0.5, -1, 0.6};

[[noreturn]] void refuse_picture(const std::string& field, const std::string& value, const std::string& wanted)
{
    throw Error(CLEFT_ERROR_ARGUMENT, field + " of the picture is " + value + "; it must be " + wanted);
}

std::string vector_text(const double* v)
{
    return "(" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + ")";
}

void check_choice(const char* field, int32_t value, int32_t greatest)
{
    if (value < 0 || value > greatest)
        refuse_picture(field, std::to_string(value), "0 to " + std::to_string(greatest));
}

int32_t side(const char* field, int32_t given, int32_t by_default)
{
    if (given < 0 || given > kGreatestSide)
        refuse_picture(field, std::to_string(given),
                       "1 to " + std::to_string(kGreatestSide) + " pixels, or 0 for the default");
    return given == 0 ? by_default : given;
}

// 0 stands for `by_default`.
double positive(const char* field, double given, double by_default, double greatest)
{
    if (!(given >= 0 && given <= greatest))  // NaN neither
        refuse_picture(field, number_text(given),
                       "above 0 and at most " + number_text(greatest) + ", or 0 for the default");
    return given == 0 ? by_default : given;
}

bool is_zero(const double* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

// Of length 1. Divided by the greatest component first, so that squares neither overflow nor vanish.
Vector3 direction(const char* field, const double* given)
{
    const double greatest = std::max({std::abs(given[0]), std::abs(given[1]), std::abs(given[2])});
    if (!std::isfinite(given[0]) || !std::isfinite(given[1]) || !std::isfinite(given[2]) || !(greatest > 0))
        refuse_picture(field, vector_text(given), "three finite numbers that are not all 0");
    const Vector3 scaled{given[0] / greatest, given[1] / greatest, given[2] / greatest};
    return times(1 / std::sqrt(dot(scaled, scaled)), scaled);
}

// Upwards is z, or y where the eye looks along z.
Vector3 upwards(const double* given, const Vector3& to_eye)
{
    // The sine of a fifth of a degree: nearer, rounding turns the picture.
    constexpr double kLeastSine = 0.0035;
    const auto is_along = [&](const Vector3& up) {
        const Vector3 normal = cross(up, to_eye);
        return dot(normal, normal) < kLeastSine * kLeastSine;
    };
    if (is_zero(given))
        return is_along({0, 0, 1}) ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
    const Vector3 up = direction("up", given);
    if (is_along(up))
        refuse_picture("up", vector_text(given), "in another direction than view");
    return up;
}

Vector3 checked_cut(const double* given)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!(given[axis] >= 0 && given[axis] <= 1))
            refuse_picture(std::string("cut along ") + "xyz"[axis], number_text(given[axis]),
                           "a share of the box, 0 to 1");
    return {given[0], given[1], given[2]};
}

std::array<double, 2> checked_range(const double* given)
{
    if (given[0] == 0 && given[1] == 0)
        return {0, 0};
    if (!std::isfinite(given[0]) || !std::isfinite(given[1]) || !(given[0] < given[1]))
        refuse_picture("range", number_text(given[0]) + " to " + number_text(given[1]),
                       "two finite numbers, the lesser first");
    return {given[0], given[1]};
}

}  // namespace

PictureRequest checked_request(const cleft_io_picture& given, std::vector<int32_t> strip, std::vector<int32_t> whole)
{
    PictureRequest request;
    check_choice("by", given.by, CLEFT_IO_BY_SIZE);
    check_choice("backdrop", given.backdrop, CLEFT_IO_BACKDROP_NONE);
    if (given.reserved != 0)  // so that it can mean something later
        refuse_picture("reserved", std::to_string(given.reserved), "0");
    request.by = given.by;
    request.backdrop = given.backdrop;
    request.width = side("width", given.width, kDefaultWidth);
    request.height = side("height", given.height, kDefaultHeight);
    request.has_edges = given.no_edges == 0;
    request.has_legend = given.legend != 0;
    request.cut = checked_cut(given.cut);
    request.to_eye = direction("view", is_zero(given.view) ? kDefaultToEye.data() : given.view);
    request.up = upwards(given.up, request.to_eye);
    request.zoom = positive("zoom", given.zoom, 1, kGreatestZoom);
    request.line_width = positive("line_width", given.line_width, 1, kGreatestLineWidth);
    request.range = checked_range(given.range);
    request.strip = std::move(strip);
    request.whole = std::move(whole);
    return request;
}

}  // namespace cleft::io
