// Reads places, spacings and the rescaling of values, and sorts planes into even slots along their normal.
#include "io/dicom_planes.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

// Functional group macros of PS3.3, section C.7.6.16.2: Plane Position, Plane Orientation, Pixel Measures, and Pixel
// Value Transformation.
constexpr DicomTag kPositionGroup = 0x00209113u;
constexpr DicomTag kOrientationGroup = 0x00209116u;
constexpr DicomTag kMeasuresGroup = 0x00289110u;
constexpr DicomTag kValuesGroup = 0x00289145u;

// The numbers of an element in a group of the frame, else of all frames, else outside of groups.
class FrameGroups
{
public:
    // `shared` and `frame` may be null. A file of one slice has its attributes outside of groups,
    // and both are null.
    FrameGroups(const DicomData& all, const DicomData* shared, const DicomData* frame)
        : sources_{frame, shared}, all_(all)
    {
    }

    std::vector<double> numbers(DicomTag group, DicomTag tag) const
    {
        for (const DicomData* source : sources_)
            if (source)
                for (const DicomData& item : source->items(group))
                    if (item.has(tag))
                        return item.numbers(tag);
        return all_.numbers(tag);
    }

private:
    std::array<const DicomData*, 2> sources_;
    const DicomData& all_;
};

// Image Position (Patient): the centre of the first voxel in LPS, in millimetres. Image Orientation (Patient):
// directions of rows and columns (PS3.3, section C.7.6.2.1.1).
void set_position(const FrameGroups& groups, DicomPlane& plane)
{
    const std::vector<double> position = groups.numbers(kPositionGroup, 0x00200032u);
    const std::vector<double> axes = groups.numbers(kOrientationGroup, 0x00200037u);
    if (position.size() != 3 || axes.size() != 6)
        return;
    plane.placed = true;
    plane.position = {position[0], position[1], position[2]};
    const Vector3 row{axes[0], axes[1], axes[2]};
    const Vector3 column{axes[3], axes[4], axes[5]};
    // Below 30 degrees between rows and columns nothing is certain any more. Directions of zeros or of one axis twice
    // come from broken converters.
    if (length(row) == 0 || length(column) == 0 || length(cross(row, column)) < 0.5 * length(row) * length(column))
        refuse_dicom("the directions of its rows and columns lie on a line");
    // Rounded to few digits in the text, directions are seldom of length 1.
    plane.along_row = times(1 / length(row), row);
    plane.along_column = times(1 / length(column), column);
}

// Pixel Spacing: the distance between rows comes first, then that between columns (PS3.3, section 10.7.1.3).
void set_pixel_spacing(const FrameGroups& groups, DicomPlane& plane)
{
    std::vector<double> pixel = groups.numbers(kMeasuresGroup, 0x00280030u);
    plane.at_detector = pixel.empty();
    if (plane.at_detector)
        pixel = groups.numbers(kMeasuresGroup, 0x00181164u);
    if (pixel.size() != 2)
        return;
    plane.sized = true;
    plane.row_spacing = pixel[0];
    plane.column_spacing = pixel[1];
}

double first_of(const std::vector<double>& numbers, double otherwise)
{
    return numbers.empty() ? otherwise : numbers.front();
}

DicomPlane plane_of(const FrameGroups& groups)
{
    DicomPlane plane;
    set_position(groups, plane);
    set_pixel_spacing(groups, plane);
    // Spacing Between Slices is negative in some files of nuclear medicine, where it counts
    // downward. Only its size is used, as places tell the direction.
    plane.between_slices = std::abs(first_of(groups.numbers(kMeasuresGroup, 0x00180088u), 0));
    plane.thickness = std::abs(first_of(groups.numbers(kMeasuresGroup, 0x00180050u), 0));
    const double slope = first_of(groups.numbers(kValuesGroup, 0x00281053u), 1);
    // A slope of 0 would make all voxels one value. Broken writers use it for "none".
    plane.slope = slope == 0 ? 1 : slope;
    plane.intercept = first_of(groups.numbers(kValuesGroup, 0x00281052u), 0);
    return plane;
}

Vector3 normal_of(const DicomPlane& plane)
{
    const Vector3 normal = cross(plane.along_row, plane.along_column);
    return times(1 / length(normal), normal);
}

void check_alike(const DicomPlane& plane, const DicomPlane& first, const std::string& who, const std::string& other)
{
    // Directions are decimal strings of at most 16 characters; scanners write six digits. A real
    // tilt between slices is far greater.
    constexpr double kTurned = 1e-3;
    // Relative, for the same reason.
    constexpr double kResized = 1e-3;
    if (!plane.placed)
        refuse_dicom(who + " does not tell where it lies");
    if (length(minus(plane.along_row, first.along_row)) > kTurned ||
        length(minus(plane.along_column, first.along_column)) > kTurned)
        refuse_dicom(who + " is turned against " + other);
    if (std::abs(plane.row_spacing - first.row_spacing) > kResized * first.row_spacing ||
        std::abs(plane.column_spacing - first.column_spacing) > kResized * first.column_spacing)
        refuse_dicom(who + " has another size of pixels than " + other);
}

struct Place {
    double height;  // along the normal
    size_t plane;
};

std::vector<Place> places_of(const std::vector<DicomPlane>& planes, const std::vector<std::string>& who)
{
    const Vector3 normal = normal_of(planes.front());
    std::vector<Place> places;
    for (size_t i = 0; i < planes.size(); ++i) {
        check_alike(planes[i], planes.front(), who[i], who.front());
        places.push_back({dot(planes[i].position, normal), i});
    }
    // Stable, so that slices at one place are named in the order of the files.
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.height < b.height; });
    return places;
}

// `count` slots from the lowest to the highest place.
DicomStack slots_of(const std::vector<DicomPlane>& planes, const std::vector<std::string>& who,
                    const std::vector<Place>& places, int64_t count)
{
    // A twentieth of a step: table positions are rounded to 0.1 mm in some files, while a missing
    // slice is off by a whole step.
    constexpr double kUneven = 0.05;
    const DicomPlane& lowest = planes[places.front().plane];
    DicomStack stack;
    stack.geometry.dims[2] = count;
    set_plane(lowest, stack.geometry);
    stack.slots.assign(planes.size(), 0);
    if (count == 1)
        return stack;
    // The step is taken from the positions and not from the normal: with a tilted gantry the stack
    // is sheared, and the mesh must be, too.
    const Vector3 way = minus(planes[places.back().plane].position, lowest.position);
    const Vector3 step = times(1 / static_cast<double>(count - 1), way);
    stack.geometry.spacing[2] = length(step);
    stack.geometry.directions[2] = times(1 / length(step), step);
    const double height = (places.back().height - places.front().height) / static_cast<double>(count - 1);
    for (const Place& place : places) {
        // Distances along the normal choose the slot; the check of the place in space follows.
        const double slot = std::round((place.height - places.front().height) / height);
        const Vector3 expected = times(slot, step);
        const Vector3 there = minus(planes[place.plane].position, lowest.position);
        if (length(minus(there, expected)) > kUneven * length(step))
            refuse_dicom("its slices are not evenly spaced: is one missing? (" + who[place.plane] + ")");
        stack.slots[place.plane] = static_cast<int64_t>(slot);
    }
    return stack;
}

// How far apart slots are that all gaps between planes are whole numbers of: as far as the file tells, else as the
// nearest two planes, unless only the thickness of a slice makes them even.
double loose_step(const DicomPlane& plane, const std::vector<double>& gaps, std::vector<std::string>& notes)
{
    // The same part of a step as slots_of() allows, so that a step that fits here fits there.
    constexpr double kUneven = 0.05;
    // Halfway between neighbours and a gap of one slice.
    constexpr double kNeighbours = 1.5;
    const auto fits = [&](double step) {
        return step > 0 && std::all_of(gaps.begin(), gaps.end(), [&](double gap) {
                   // A gap below half a step would round to 0 and put two planes into one slot.
                   return gap > 0.5 * step && std::abs(gap / step - std::round(gap / step)) <= kUneven;
               });
    };
    const double least_gap = *std::min_element(gaps.begin(), gaps.end());
    // A stated spacing greater than a real gap is wrong, and would put different planes into one
    // slot.
    double step = plane.between_slices;
    if (step == 0 || step > (1 + kUneven) * least_gap)
        step = fits(least_gap) || !fits(plane.thickness) ? least_gap : plane.thickness;
    if (least_gap > kNeighbours * step)
        notes.push_back("its frames are " + number_text(least_gap) + " apart or more, but its slices " +
                        number_text(step) + ": nothing is taken to lie in the slices that have no frame");
    else if (plane.between_slices == 0 && plane.thickness > 0 && step > kNeighbours * plane.thickness)
        notes.push_back("it does not tell how far its slices are apart: " + number_text(step) +
                        " is taken, as between frames, and not their thickness of " + number_text(plane.thickness));
    return step;
}

// A thousandth of a pixel: planes of one place differ by rounding only.
double same_place(const std::vector<DicomPlane>& planes)
{
    return 1e-3 * std::min(planes.front().row_spacing, planes.front().column_spacing);
}

}  // namespace

std::vector<DicomPlane> planes_of(const DicomFile& file, int64_t frames)
{
    const std::vector<DicomData> shared = file.data.items(kSharedGroups);
    const std::vector<DicomData> own = file.data.items(kFrameGroups);
    // Per-Frame Functional Groups Sequence has one item for each frame. With another number, no
    // frame has a certain place.
    if (!own.empty() && static_cast<int64_t>(own.size()) != frames)
        refuse_dicom("the DICOM file is damaged: it has " + counted(frames, "frame") + ", but describes " +
                     std::to_string(own.size()));
    std::vector<DicomPlane> planes;
    for (int64_t f = 0; f < frames; ++f)
        planes.push_back(plane_of(FrameGroups(file.data, shared.empty() ? nullptr : &shared.front(),
                                              own.empty() ? nullptr : &own[static_cast<size_t>(f)])));
    return planes;
}

DicomStack stack_of(const std::vector<DicomPlane>& planes, const std::vector<std::string>& who)
{
    const std::vector<Place> places = places_of(planes, who);
    for (size_t i = 1; i < places.size(); ++i)
        if (places[i].height - places[i - 1].height < same_place(planes))
            refuse_dicom(who[places[i - 1].plane] + " and " + who[places[i].plane] +
                         " lie at the same place: a series over time, or of several contrasts, is no volume");
    return slots_of(planes, who, places, static_cast<int64_t>(places.size()));
}

DicomStack loose_stack_of(const std::vector<DicomPlane>& planes, const std::vector<std::string>& who)
{
    // Two frames a hair apart would otherwise ask for millions of empty slices between the others.
    constexpr double kMostSlices = 65536;
    const std::vector<Place> places = places_of(planes, who);
    std::vector<double> gaps;
    for (size_t i = 1; i < places.size(); ++i)
        if (const double gap = places[i].height - places[i - 1].height; gap > same_place(planes))
            gaps.push_back(gap);
    // All segments have frames in one plane: a volume of one slice.
    if (gaps.empty())
        return slots_of(planes, who, places, 1);
    std::vector<std::string> notes;
    const double height = places.back().height - places.front().height;
    const double steps = std::round(height / loose_step(planes.front(), gaps, notes));
    if (steps + 1 > kMostSlices)
        refuse_dicom("its slices are not evenly spaced");
    DicomStack stack = slots_of(planes, who, places, static_cast<int64_t>(std::max(1.0, steps)) + 1);
    stack.geometry.notes = std::move(notes);
    return stack;
}

void set_plane(const DicomPlane& plane, Image& image)
{
    image.directions = {plane.along_row, plane.along_column, normal_of(plane)};
    // The order of axes is x along a row, y along a column, z along the normal. Without any
    // distance of slices voxels are as thick as they are wide.
    image.spacing = {plane.column_spacing, plane.row_spacing,
                     plane.slice_spacing() > 0 ? plane.slice_spacing() : plane.column_spacing};
    image.origin = plane.position;
}

void set_place(const DicomStack& stack, Image& volume)
{
    volume.directions = stack.geometry.directions;
    volume.spacing = stack.geometry.spacing;
    volume.origin = stack.geometry.origin;
}

void copy_to_slots(const DicomStack& stack, const Image& frames, Image& volume)
{
    const size_t bytes = frames.bytes() / stack.slots.size();
    for (size_t i = 0; i < stack.slots.size(); ++i)
        std::memcpy(volume.voxels.get() + static_cast<size_t>(stack.slots[i]) * bytes, frames.voxels.get() + i * bytes,
                    bytes);
}

void put_in_slots(const DicomStack& stack, Image& volume)
{
    Image sorted;
    sorted.dims = volume.dims;
    sorted.component = volume.component;
    allocate_voxels(sorted);
    // A second copy is made, as slices cannot change places within one array without a scratch
    // slice for each cycle.
    copy_to_slots(stack, volume, sorted);
    volume.voxels = std::move(sorted.voxels);
    set_place(stack, volume);
}

void rescale(const std::vector<DicomPlane>& planes, Image& image)
{
    // With it, 16 bits times slope plus intercept stay within 32 bits.
    constexpr double kGreatestFactor = 1000;
    const auto changes = [](const DicomPlane& plane) { return plane.slope != 1 || plane.intercept != 0; };
    const auto whole = [](double value) { return value == std::round(value); };
    if (std::none_of(planes.begin(), planes.end(), changes))
        return;
    // Rescale Slope and Intercept (PS3.3, section C.11.1). Whole ones, such as 1 and -1024 of CT,
    // keep whole numbers whole. Else values are of double.
    bool integer = size_of(image.component) <= 2;
    for (const DicomPlane& plane : planes)
        integer = integer && whole(plane.slope) && whole(plane.intercept) && std::abs(plane.slope) < kGreatestFactor &&
                  std::abs(plane.intercept) < 1e6;
    Image scaled;
    scaled.dims = image.dims;
    scaled.component = integer ? Component::int32 : Component::float64;
    allocate_voxels(scaled);
    const int64_t slice = image.dims[0] * image.dims[1];
    for_each_value(image, 0, [&](int64_t voxel, double stored) {
        const DicomPlane& plane = planes[static_cast<size_t>(voxel / slice)];
        const double value = plane.slope * stored + plane.intercept;
        if (integer)
            store<int32_t>(scaled.voxels.get(), voxel, static_cast<int32_t>(value));
        else
            store<double>(scaled.voxels.get(), voxel, value);
    });
    image.component = scaled.component;
    image.voxels = std::move(scaled.voxels);
}

}  // namespace cleft::io
