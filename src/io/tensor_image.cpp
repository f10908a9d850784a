// Brings tensors of files into one order, and from the coordinates of the file into those of the mesh.
#include "io/tensor_image.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "io/voxel_access.hpp"
#include "io/voxels.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

using Six = std::array<double, 6>;
using Rows = std::array<Vector3, 3>;

// Where xx, xy, xz, yy, yz and zz stand in six numbers.
std::array<size_t, 6> places_in(cleft_io_tensor_order order)
{
    switch (order) {
        case CLEFT_IO_ORDER_NRRD:
            return {0, 1, 2, 3, 4, 5};
        case CLEFT_IO_ORDER_VTK:
            return {0, 3, 5, 1, 4, 2};
        case CLEFT_IO_ORDER_NIFTI:
            return {0, 1, 3, 2, 4, 5};
        default:
            throw Error(CLEFT_ERROR_ARGUMENT, "there is no order " + std::to_string(order) + " of tensors");
    }
}

const char* text_of_order(cleft_io_tensor_order order)
{
    return order == CLEFT_IO_ORDER_NRRD  ? "xx xy xz yy yz zz (nrrd)"
           : order == CLEFT_IO_ORDER_VTK ? "xx yy zz xy yz xz (vtk)"
                                         : "xx xy yy xz yz zz (nifti)";
}

// The order that holds.
cleft_io_tensor_order settled_order(const TensorImage& tensors, cleft_io_tensor_order wanted)
{
    if (wanted != CLEFT_IO_ORDER_FILE)
        places_in(wanted);  // throws if there is none
    if (tensors.order == CLEFT_IO_ORDER_FILE && wanted == CLEFT_IO_ORDER_FILE && tensors.image.fields == 6)
        throw Error(CLEFT_ERROR_FORMAT,
                    "it has six numbers a voxel and does not say in which order: say whether they are "
                    "xx xy xz yy yz zz (nrrd), xx yy zz xy yz xz (vtk) or xx xy yy xz yz zz (nifti)");
    if (tensors.order != CLEFT_IO_ORDER_FILE && wanted != CLEFT_IO_ORDER_FILE && tensors.order != wanted)
        throw Error(CLEFT_ERROR_FORMAT, std::string("its tensors are in the order ") + text_of_order(tensors.order) +
                                            " by its header, not " + text_of_order(wanted));
    return wanted == CLEFT_IO_ORDER_FILE ? tensors.order : wanted;
}

// Takes tensors of an image of float or double out of it.
class TensorTaker
{
public:
    TensorTaker(const TensorImage& tensors, cleft_io_tensor_order order)
        : image_(tensors.image),
          step_(tensors.side_by_side ? 1 : image_.field_size()),
          voxel_step_(tensors.side_by_side ? image_.fields : 1)
    {
        if (image_.fields != 9)
            places_ = places_in(order);
    }

    Six at(int64_t voxel) const
    {
        if (image_.fields == 9)
            return symmetric(voxel);
        const bool is_masked = image_.fields == 7;
        if (is_masked && number(voxel, 0) != 1)
            throw Error(CLEFT_ERROR_FORMAT, "the mask of " + voxel_in_words(voxel, image_.dims) + " is " +
                                                number_text(number(voxel, 0)) +
                                                "; it must be 1, as a metric is wanted at each voxel");
        Six six{};
        for (size_t c = 0; c < 6; ++c)
            six[c] = number(voxel, static_cast<int64_t>(places_[c]) + (is_masked ? 1 : 0));
        return six;
    }

private:
    double number(int64_t voxel, int64_t c) const
    {
        const int64_t index = voxel_step_ * voxel + step_ * c;
        return image_.component == Component::float32 ? double{load<float>(image_.voxels.get(), index)}
                                                      : load<double>(image_.voxels.get(), index);
    }

    // The numbers are read by rows; by columns a symmetric tensor is the same.
    Six symmetric(int64_t voxel) const
    {
        // What programs leave of symmetry that compute in single precision.
        constexpr double kTolerance = 1e-5;
        double greatest = 0;
        for (int64_t c = 0; c < 9; ++c)
            greatest = std::max(greatest, std::abs(number(voxel, c)));
        static constexpr struct {
            int64_t upper, lower;
            const char* names;
        } kPairs[] = {{1, 3, "xy and yx"}, {2, 6, "xz and zx"}, {5, 7, "yz and zy"}};
        for (const auto& pair : kPairs) {
            const double a = number(voxel, pair.upper), b = number(voxel, pair.lower);
            // What is not finite is for the core to refuse.
            if (std::abs(a - b) > kTolerance * greatest)
                throw Error(CLEFT_ERROR_FORMAT, "the tensor of " + voxel_in_words(voxel, image_.dims) +
                                                    " is not symmetric: its " + pair.names + " are " + number_text(a) +
                                                    " and " + number_text(b));
        }
        const auto mean = [&](int64_t a, int64_t b) { return (number(voxel, a) + number(voxel, b)) / 2; };
        return {number(voxel, 0), mean(1, 3), mean(2, 6), number(voxel, 4), mean(5, 7), number(voxel, 8)};
    }

    const Image& image_;
    int64_t step_, voxel_step_;
    std::array<size_t, 6> places_{};
};

// F M F^T, of columns of F.
Six mapped(const Six& m, const Rows& columns)
{
    const Rows rows{Vector3{m[0], m[1], m[2]}, Vector3{m[1], m[3], m[4]}, Vector3{m[2], m[4], m[5]}};
    const auto entry = [&](size_t i, size_t j) {
        double sum = 0;
        for (size_t k = 0; k < 3; ++k)
            for (size_t l = 0; l < 3; ++l)
                sum += columns[k][i] * rows[k][l] * columns[l][j];
        return sum;
    };
    return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

void check_right_angles(const Rows& frame)
{
    // Headers have few digits. A frame that is not of unit vectors at right angles would change lengths.
    constexpr double kTolerance = 1e-4;
    for (size_t a = 0; a < 3; ++a)
        for (size_t b = a; b < 3; ++b)
            if (!(std::abs(dot(frame[a], frame[b]) - (a == b ? 1 : 0)) <= kTolerance))
                throw Error(CLEFT_ERROR_UNSUPPORTED,
                            "its measurement frame is not of three unit vectors at right angles, so it does not say "
                            "what the metric measures");
}

}  // namespace

std::vector<double> metric_of(TensorImage tensors, cleft_io_tensor_order order, const cleft_io_reading& reading)
{
    const int64_t fields = tensors.image.fields;
    if (fields != 6 && fields != 7 && fields != 9)
        throw Error(CLEFT_ERROR_FORMAT,
                    "it has " + std::to_string(fields) + " numbers a voxel; a metric has six, a mask and six, or nine");
    order = settled_order(tensors, order);
    check_right_angles(tensors.frame);
    make_floating(tensors.image);
    Rows frame = tensors.frame;
    for (Vector3& axis : frame)
        for (size_t row = 0; row < 2; ++row)
            axis[row] *= reading.world == CLEFT_IO_WORLD_RAS ? -1 : 1;
    // Lengths grow by the scale, so what measures them shrinks by its square.
    const double factor = 1 / (reading.scale * reading.scale);
    const TensorTaker taker(tensors, order);
    std::vector<double> metric;
    metric.reserve(static_cast<size_t>(6 * tensors.image.field_size()));
    for (int64_t voxel = 0; voxel < tensors.image.field_size(); ++voxel)
        for (const double number : mapped(taker.at(voxel), frame))
            metric.push_back(factor * number);
    return metric;
}

}  // namespace cleft::io
