// Places the voxels of an NRRD file in the world, by its space or by its spacings.
#include "io/nrrd_geometry.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/header_values.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

// Relative: a spacing and an extent that were written with few digits may differ by so much.
constexpr double kVoxelTolerance = 1e-3;

bool is_space_kind(const std::string& kind) { return kind == "domain" || kind == "space"; }
// Kinds of axes along which there are several volumes. Those of colours, vectors and tensors are not among them.
// "kinds" of the NRRD definition. "none" and "???" say nothing of an axis. Files of Slicer have
// "list", series over time "time".
bool is_list_kind(const std::string& kind)
{
    return kind == "list" || kind == "time" || kind == "none" || kind == "???" || is_space_kind(kind);
}

bool is_spatial(const NrrdHeader& header, size_t axis)
{
    // "space directions" has "none" for an axis that is not of space, which is the surest sign.
    if (!header.directions.empty())
        return header.directions[axis].has_value();
    if (!header.kinds.empty() && header.kinds[axis] != "???" && header.kinds[axis] != "none")
        return is_space_kind(header.kinds[axis]);
    return true;
}

// What turns a vector of the space into LPS.
Vector3 signs_of(const NrrdHeader& header, Image& image)
{
    // "space" of the NRRD definition. Spaces with time have four dimensions and are refused.
    const std::string& space = header.space;
    if (space.empty() || space == "left-posterior-superior" || space == "lps" || space == "scanner-xyz" ||
        space == "scannerxyz" || space == "3d-right-handed" || space == "3dright-handed")
        return {1, 1, 1};
    if (space == "right-anterior-superior" || space == "ras")
        return {-1, -1, 1};
    if (space == "left-anterior-superior" || space == "las")
        return {1, -1, 1};
    // A scanner-independent left-handed space has no relation to LPS. Its coordinates stay, and the
    // user gets a note.
    if (space == "3d-left-handed" || space == "3dleft-handed") {
        image.notes.emplace_back("its space is '" + space + "', whose coordinates are taken as they are");
        return {1, 1, 1};
    }
    refuse_field("space", space, "such coordinates cannot be read");
}

size_t space_dimension_of(const NrrdHeader& header)
{
    // The NRRD definition allows one of the two fields only.
    if (header.space_dimension > 0 && !header.space.empty())
        refuse_field("space dimension", std::to_string(header.space_dimension), "there is a field 'space', too");
    const size_t dimension = header.space.empty() ? header.space_dimension : 3;
    if (dimension != 2 && dimension != 3)
        throw Error(CLEFT_ERROR_FORMAT, dimension == 0
                                            ? "its header has directions or an origin, but no field 'space'"
                                            : "its space has " + counted(static_cast<int64_t>(dimension), "dimension"));
    return dimension;
}

Vector3 vector_of(const char* field, const std::vector<double>& numbers, size_t dimension, const Vector3& signs)
{
    if (numbers.size() != dimension)
        throw Error(CLEFT_ERROR_FORMAT, std::string("a vector of its field '") + field + "' has " +
                                            counted(static_cast<int64_t>(numbers.size()), "number") +
                                            ", but its space has " + std::to_string(dimension) + " dimensions");
    Vector3 vector{0, 0, 0};
    for (size_t row = 0; row < dimension; ++row)
        // + 0.0 makes 0 of -0, which would show in written headers.
        vector[row] = signs[row] * numbers[row] + 0.0;
    return vector;
}

void set_step(size_t axis, const Vector3& step, Image& image)
{
    image.spacing[axis] = length(step);
    // A step of no length keeps the default direction. The spacing stays 0, so that the user is
    // asked for it.
    if (image.spacing[axis] > 0 && std::isfinite(image.spacing[axis]))
        image.directions[axis] = times(1 / image.spacing[axis], step);
}

// A plane is as thick as its voxels are wide.
void set_thickness(size_t dimension, Image& image)
{
    image.spacing[2] = image.spacing[0];
    const Vector3 normal = cross(image.directions[0], image.directions[1]);
    if (dimension == 3 && length(normal) > 0)
        image.directions[2] = times(1 / length(normal), normal);
}

void set_from_space(const NrrdHeader& header, const NrrdAxes& axes, Image& image)
{
    const size_t dimension = space_dimension_of(header);
    const Vector3 signs = signs_of(header, image);
    if (axes.space.size() > dimension)
        throw Error(CLEFT_ERROR_FORMAT, "it has more axes of space than its space has dimensions");
    for (size_t a = 0; a < axes.space.size(); ++a) {
        // NaN in "spacings" means that an axis has none. The NRRD definition forbids both for one
        // axis.
        if (!header.spacings.empty() && !std::isnan(header.spacings[axes.space[a]]))
            throw Error(CLEFT_ERROR_FORMAT, "an axis has both a spacing and a direction");
        set_step(a, vector_of("space directions", *header.directions[axes.space[a]], dimension, signs), image);
    }
    if (axes.space.size() == 2)
        set_thickness(dimension, image);
    if (!header.origin.empty())
        image.origin = vector_of("space origin", header.origin, dimension, signs);
}

// An extent from `low` to `high` goes from side to side of the voxels, or from centre to centre where that is said.
void set_axis(const NrrdHeader& header, size_t axis, size_t a, Image& image)
{
    // NaN in the fields per axis means "not known" (NRRD definition), so it stands for a missing
    // field here, too.
    const double nan = std::nan("");
    const double low = header.mins.empty() ? nan : header.mins[axis];
    const double high = header.maxs.empty() ? nan : header.maxs[axis];
    // "node": the minimum is the centre of the first voxel. "cell": it is that voxel's side.
    const bool nodes = !header.centers.empty() && header.centers[axis] == "node";
    const auto count = static_cast<double>(header.sizes[axis]);
    const double steps = nodes ? count - 1 : count;
    double spacing = header.spacings.empty() ? nan : header.spacings[axis];
    // One node has no step, whatever its extent is.
    if (!std::isnan(low) && !std::isnan(high) && steps > 0) {
        const double derived = (high - low) / steps;
        if (!std::isnan(spacing) && std::abs(spacing - derived) > kVoxelTolerance * std::abs(spacing))
            throw Error(CLEFT_ERROR_FORMAT, "its spacing along the " + ordinal(static_cast<int64_t>(axis)) +
                                                " axis is " + std::to_string(spacing) +
                                                ", but its minimum and maximum tell of " + std::to_string(derived));
        spacing = derived;
    }
    if (std::isnan(spacing) && (!header.spacings.empty() || !std::isnan(low)))
        image.notes.emplace_back("it gives no spacing along the " + ordinal(static_cast<int64_t>(axis)) +
                                 " axis, which is taken for 1");
    Vector3 step{0, 0, 0};
    step[a] = std::isnan(spacing) ? 1 : spacing;
    set_step(a, step, image);
    // A maximum alone places the axis from its other end.
    const double first = !std::isnan(low) ? low : high - steps * step[a];
    if (!std::isnan(first))
        image.origin[a] = nodes ? first : first + step[a] / 2;
}

void set_from_axes(const NrrdHeader& header, const NrrdAxes& axes, Image& image)
{
    // An origin is a point of a space, which no direction relates to the axes here.
    if (!header.origin.empty())
        throw Error(CLEFT_ERROR_FORMAT, "its header has a field 'space origin', but no 'space directions'");
    for (const std::string& center : header.centers)
        if (center != "cell" && center != "node" && center != "none" && center != "???")
            refuse_field("centers", center, "cell or node is wanted");
    for (size_t a = 0; a < axes.space.size(); ++a)
        set_axis(header, axes.space[a], a, image);
    if (axes.space.size() == 2)
        set_thickness(2, image);
    const bool placed = !header.mins.empty() || !header.maxs.empty();
    const bool is_stated = std::any_of(header.centers.begin(), header.centers.end(),
                                       [](const std::string& center) { return center == "cell" || center == "node"; });
    if (placed && !is_stated)
        image.notes.emplace_back(
            "it does not say whether the ends of its axes are centres or sides of voxels; they "
            "are taken for sides");
}

}  // namespace

NrrdAxes nrrd_axes(const NrrdHeader& header)
{
    NrrdAxes axes;
    std::vector<size_t> others;
    const size_t dimension = header.sizes.size();
    for (size_t axis = 0; axis < dimension; ++axis) {
        // Without directions, a fourth axis with one sample is of no space. Some writers append it
        // for time or colour.
        if (is_spatial(header, axis) && (axes.space.size() < 3 || header.sizes[axis] > 1 || !header.directions.empty()))
            axes.space.push_back(axis);
        // An axis of one sample changes nothing about the voxels, wherever it stands.
        else if (header.sizes[axis] > 1)
            others.push_back(axis);
    }
    if (axes.space.size() == 4 && header.directions.empty() && others.empty() && axes.space.back() == dimension - 1) {
        others.push_back(dimension - 1);  // four axes of which nothing else is said: the last one counts volumes
        axes.space.pop_back();
    }
    if (axes.space.size() < 2 || axes.space.size() > 3)
        throw Error(CLEFT_ERROR_FORMAT,
                    "a volume has two or three axes of space, but it has " + std::to_string(axes.space.size()));
    for (const size_t axis : others)
        if (!header.kinds.empty() && !is_list_kind(header.kinds[axis]))
            throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(header.sizes[axis]) +
                                                " numbers a voxel (colours or vectors: '" + header.kinds[axis] +
                                                "'); one is wanted");
    if (others.size() > 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(others.size() + axes.space.size()) +
                                            " axes with more than one voxel; a volume has three, or four");
    if (!others.empty()) {
        // Samples of one volume would then neither follow each other nor be interleaved voxel by
        // voxel.
        if (others[0] > axes.space.front() && others[0] < axes.space.back())
            throw Error(CLEFT_ERROR_FORMAT, "its axis of kind 'list' lies between its axes of space");
        axes.other = others[0];
    }
    return axes;
}

NrrdAxes nrrd_tensor_axes(const NrrdHeader& header)
{
    NrrdAxes axes;
    // Nothing is said of axes without directions and kinds. The numbers of a voxel come first, as all writers have it.
    const bool is_silent = header.directions.empty() && header.kinds.empty();
    for (size_t axis = 0; axis < header.sizes.size(); ++axis) {
        if (is_silent ? axis > 0 : is_spatial(header, axis))
            axes.space.push_back(axis);
        else if (!axes.other)
            axes.other = axis;
    }
    if (axes.space.size() != 3 || header.sizes.size() != 4)
        throw Error(CLEFT_ERROR_FORMAT, "a metric has three axes of space and one of numbers, but it has " +
                                            counted(static_cast<int64_t>(axes.space.size()), "axis", "axes") +
                                            " of space among " + std::to_string(header.sizes.size()));
    if (*axes.other != 0 && *axes.other != 3)
        throw Error(CLEFT_ERROR_FORMAT, "the axis of the numbers of its tensors lies between its axes of space");
    return axes;
}

std::array<Vector3, 3> nrrd_measurement_frame(const NrrdHeader& header)
{
    Image unused;  // whose notes set_nrrd_geometry() has given already
    const Vector3 signs = header.directions.empty() ? Vector3{1, 1, 1} : signs_of(header, unused);
    std::array<Vector3, 3> frame{Vector3{signs[0], 0, 0}, Vector3{0, signs[1], 0}, Vector3{0, 0, signs[2]}};
    if (header.measurement_frame.empty())
        return frame;
    const auto vectors = nrrd_vectors("measurement frame", header.measurement_frame);
    if (vectors.size() != 3 || !vectors[0] || !vectors[1] || !vectors[2])
        refuse_field("measurement frame", header.measurement_frame, "three vectors are wanted");
    for (size_t a = 0; a < 3; ++a)
        frame[a] = vector_of("measurement frame", *vectors[a], 3, signs);
    return frame;
}

void set_nrrd_geometry(const NrrdHeader& header, const NrrdAxes& axes, Image& image)
{
    if (header.directions.empty())
        set_from_axes(header, axes, image);
    else
        set_from_space(header, axes, image);
}

}  // namespace cleft::io
