// The door of the folder: checks what a volume is made of, and sends each question to the label map or to the
// functions.
#include "volume/volume.hpp"

#include "base/counted.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "base/stage.hpp"
#include "volume/indicator_field.hpp"
#include "volume/label_depth.hpp"
#include "volume/label_planes.hpp"
#include "volume/label_sample.hpp"
#include "volume/label_values.hpp"
#include "volume/label_weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <variant>

namespace cleft
{

struct Volume::Data {
    std::variant<LabelMap<uint8_t>, LabelMap<uint16_t>, IndicatorField> field;
    Array<UserLabel> labels;
    // Several steps ask for them, each of which would pass over all voxels.
    std::mutex counting;
    Array<int64_t> counts;

    // body(map) with the label map.
    template <class Body>
    void visit_map(const Body& body)
    {
        if (auto* narrow = std::get_if<LabelMap<uint8_t>>(&field))
            body(*narrow);
        else if (auto* wide = std::get_if<LabelMap<uint16_t>>(&field))
            body(*wide);
        else
            throw std::logic_error("a part of indicator functions was asked for");
    }
};

namespace
{

void check_grid(const Grid& grid)
{
    for (int a = 0; a < 3; ++a)
        if (grid.dims[a] < 1)
            throw Error(CLEFT_ERROR_ARGUMENT,
                        "a volume needs at least one voxel along each axis, but the number along the " + ordinal(a) +
                            " is " + std::to_string(grid.dims[a]));
    for (int a = 0; a < 3; ++a)
        if (!(grid.spacing[a] > 0) || !std::isfinite(grid.spacing[a]))
            throw Error(CLEFT_ERROR_ARGUMENT, "the spacing along the " + ordinal(a) + " axis is " +
                                                  number_text(grid.spacing[a]) + ", not a positive finite number");
    const double voxels = double(grid.dims[0]) * double(grid.dims[1]) * double(grid.dims[2]);
    // From C, make_frame() has refused far fewer. This bound only keeps Grid::size() and counts of bytes within
    // int64_t.
    if (voxels > 0x1p56)
        throw std::bad_alloc();
}

template <class Label, class Value>
LabelMap<Label> make_label_map(const Value* voxels, const Grid& grid, int kernel, const Array<UserLabel>& labels,
                               const Run& run)
{
    LabelMap<Label> map;
    map.grid = grid;
    map.kernel = Hann(kernel);
    map.planes = {0, grid.dims[2]};
    // The surplus lets a sample read whole lanes at the last voxel too.
    map.material.resize(grid.size() + kLanes);
    Steps steps(run, {{nullptr, 2}, {nullptr, 10}, {nullptr, 80}});
    dense_materials(voxels, grid.size(), labels, map.material.data(), steps.next());
    find_depths(map, steps.next());
    find_weights(map, steps.next());
    return map;
}

// Most volumes have few labels. One byte per voxel halves the memory of the map, which is worth a second instantiation.
constexpr size_t kNarrowLabels = 256;

// The map of voxels whose labels are in data.labels.
template <class Value>
void store_map(const Value* voxels, const Grid& grid, int kernel, Volume::Data& data, const Run& run)
{
    if (data.labels.size() <= kNarrowLabels)
        data.field = make_label_map<uint8_t>(voxels, grid, kernel, data.labels, run);
    else
        data.field = make_label_map<uint16_t>(voxels, grid, kernel, data.labels, run);
}

// Calls body(values) with the voxels as what they are.
template <class Body>
void with_type(VoxelType type, const void* voxels, const Body& body)
{
    if (!voxels)
        throw Error(CLEFT_ERROR_NULL, "the voxels are NULL");
    switch (type) {
        case VoxelType::uint8:
            return body(static_cast<const uint8_t*>(voxels));
        case VoxelType::uint16:
            return body(static_cast<const uint16_t*>(voxels));
        case VoxelType::int16:
            return body(static_cast<const int16_t*>(voxels));
        case VoxelType::uint32:
            return body(static_cast<const uint32_t*>(voxels));
        case VoxelType::int32:
            return body(static_cast<const int32_t*>(voxels));
    }
    throw Error(CLEFT_ERROR_ARGUMENT, "the voxel type is unknown");
}

void check_kernel(int kernel)
{
    if (kernel < 2 || kernel > 6)
        throw Error(CLEFT_ERROR_ARGUMENT, "the kernel width is " + std::to_string(kernel) + ", not within 2 .. 6");
}

// The names of the materials of K fields.
// Fields without labels get 0 .. K-1, so that a material always has a value by which a caller can find it.
Array<UserLabel> indicator_labels(size_t fields, const Array<UserLabel>& labels)
{
    const size_t materials = fields == 1 ? 2 : fields;
    if (labels.empty()) {
        Array<UserLabel> numbers;
        for (size_t i = 0; i < materials; ++i)
            numbers.push_back(UserLabel{static_cast<int32_t>(i)});
        return numbers;
    }
    if (labels.size() != materials)
        throw Error(CLEFT_ERROR_ARGUMENT, counted(static_cast<int64_t>(labels.size()), "label is", "labels are") +
                                              " given for " + counted(static_cast<int64_t>(materials), "material"));
    auto sorted = labels;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        throw Error(CLEFT_ERROR_ARGUMENT, name_of(*twice) + " is given to two materials");
    return labels;
}

template <class Value>
void store_indicators(const Array<const Value*>& fields, const Grid& grid, const Array<UserLabel>& labels,
                      Volume::Data& data, const Run& run)
{
    Stage stage(run, "volume", {{"volume: functions", 1}});
    check_grid(grid);
    if (fields.empty())
        throw Error(CLEFT_ERROR_ARGUMENT, "at least one indicator function is needed");
    if (fields.size() > kGreatestLabelCount)
        throw Error(CLEFT_ERROR_ARGUMENT, "more than 65535 indicator functions are given");
    for (size_t k = 0; k < fields.size(); ++k)
        if (!fields[k])
            throw Error(CLEFT_ERROR_NULL, "the " + ordinal(static_cast<int64_t>(k)) + " indicator function is NULL");
    data.labels = indicator_labels(fields.size(), labels);
    data.field = make_indicators(fields, grid, stage.next());
    run.report(1);
}

// Where a row of voxels begins with this many equal ones, they count as one.
constexpr int64_t kEqualVoxels = 64;

template <class Label>
bool all_equal(const Label* voxels, Label value)
{
    unsigned different = 0;
    for (int64_t i = 0; i < kEqualVoxels; ++i)
        different |= static_cast<unsigned>(voxels[i] ^ value);
    return different == 0;
}

template <class Label>
Array<int64_t> counts_of(const LabelMap<Label>& map, size_t materials)
{
    Array<int64_t> counts(materials, 0);
    const Label* voxels = map.material.data();
    const int64_t n = map.grid.size();
    for (int64_t v = 0; v < n;)
        if (v + kEqualVoxels <= n && all_equal(voxels + v, voxels[v])) {
            counts[voxels[v]] += kEqualVoxels;
            v += kEqualVoxels;
        } else {
            ++counts[voxels[v++]];
        }
    return counts;
}

Array<int64_t> counts_of(const IndicatorField& field, size_t materials)
{
    Array<int64_t> counts(materials, 0);
    for (int64_t v = 0; v < field.grid.size(); ++v)
        ++counts[voxel_material(field, v)];
    return counts;
}

}  // namespace

Volume Volume::from_labels(VoxelType type, const void* voxels, const Grid& grid, int kernel, const Run& run)
{
    check_grid(grid);
    check_kernel(kernel);
    auto data = std::make_unique<Data>();
    with_type(type, voxels, [&](const auto* values) {
        Stage stage(run, "volume", {{"volume: labels", 10}, {"volume: smoothing", 90}});
        data->labels = distinct_labels(values, grid.size(), stage.next());
        store_map(values, grid, kernel, *data, stage.next());
        run.report(1);
    });
    return Volume(std::move(data));
}

LabelCounts Volume::count_labels(VoxelType type, const void* voxels, int64_t count, const Run& run)
{
    LabelCounts out;
    with_type(type, voxels, [&](const auto* values) {
        out.labels = distinct_labels(values, count, run);
        Array<uint16_t> materials(to_size(count));
        dense_materials(values, count, out.labels, materials.data(), run);
        out.voxels.assign(out.labels.size(), 0);
        for (const uint16_t m : materials)
            ++out.voxels[m];
    });
    return out;
}

Volume Volume::from_planes(VoxelType type, const void* voxels, const Grid& whole, Planes read,
                           const LabelCounts& of_whole, int kernel, const Run& run)
{
    check_grid(whole);
    check_kernel(kernel);
    CLEFT_ASSERT(read.first >= 0 && read.count > 0 && read.end() <= whole.dims[2]);
    Grid grid = whole;
    grid.dims[2] = read.count;
    auto data = std::make_unique<Data>();
    data->labels = of_whole.labels;
    data->counts = of_whole.voxels;
    with_type(type, voxels, [&](const auto* values) { store_map(values, grid, kernel, *data, run); });
    data->visit_map([&](auto& map) { place_in_whole(map, whole, read.first); });
    return Volume(std::move(data));
}

Volume Volume::from_stored_planes(const Grid& whole, Planes sampled, const LabelCounts& of_whole, int kernel,
                                  const std::function<Array<unsigned char>(int32_t k)>& plane)
{
    auto data = std::make_unique<Data>();
    data->labels = of_whole.labels;
    data->counts = of_whole.voxels;
    if (data->labels.size() <= kNarrowLabels)
        data->field = restored<uint8_t>(whole, sampled, kernel, plane);
    else
        data->field = restored<uint16_t>(whole, sampled, kernel, plane);
    return Volume(std::move(data));
}

Array<unsigned char> Volume::stored_plane(int32_t k) const
{
    Array<unsigned char> bytes;
    data_->visit_map([&](const auto& map) { bytes = cleft::stored_plane(map, k); });
    return bytes;
}

Volume Volume::cropped(Planes planes) const
{
    auto data = std::make_unique<Data>();
    data->labels = data_->labels;
    data_->visit_map([&](const auto& map) { data->field = cleft::cropped(map, planes); });
    return Volume(std::move(data));
}

Volume Volume::from_indicators(const Array<const float*>& fields, const Grid& grid, const Array<UserLabel>& labels,
                               const Run& run)
{
    auto data = std::make_unique<Data>();
    store_indicators(fields, grid, labels, *data, run);
    return Volume(std::move(data));
}

Volume Volume::from_indicators(const Array<const double*>& fields, const Grid& grid, const Array<UserLabel>& labels,
                               const Run& run)
{
    auto data = std::make_unique<Data>();
    store_indicators(fields, grid, labels, *data, run);
    return Volume(std::move(data));
}

Volume::Volume(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Volume::Volume(Volume&&) noexcept = default;
Volume& Volume::operator=(Volume&&) noexcept = default;
Volume::~Volume() = default;

const Grid& Volume::grid() const
{
    return std::visit([](const auto& field) -> const Grid& { return field.grid; }, data_->field);
}

const Array<UserLabel>& Volume::labels() const { return data_->labels; }

Array<Material> Volume::listed() const
{
    Array<Material> materials(labels().size());
    std::iota(materials.begin(), materials.end(), 0);
    // Dense numbers follow the order of the voxels. Users look for a label by its value, so lists for them ascend by
    // it.
    if (is_label_map())
        std::sort(materials.begin(), materials.end(),
                  [&](Material a, Material b) { return labels()[a] < labels()[b]; });
    return materials;
}

bool Volume::is_label_map() const { return !std::holds_alternative<IndicatorField>(data_->field); }

int64_t Volume::indicator_count() const
{
    const auto* indicators = std::get_if<IndicatorField>(&data_->field);
    return indicators ? indicators->field.count() : 0;
}

int Volume::kernel_width() const
{
    return std::visit(
        [](const auto& field) {
            if constexpr (std::is_same_v<std::decay_t<decltype(field)>, IndicatorField>)
                return 0;
            else
                return field.kernel.width();
        },
        data_->field);
}

Material Volume::voxel_material(int64_t voxel) const
{
    return std::visit([&](const auto& field) { return cleft::voxel_material(field, voxel); }, data_->field);
}

void Volume::voxel_materials(int64_t first, int64_t count, Material* out) const
{
    std::visit(
        [&](const auto& field) {
            if constexpr (std::is_same_v<std::decay_t<decltype(field)>, IndicatorField>)
                for (int64_t i = 0; i < count; ++i)
                    out[i] = cleft::voxel_material(field, first + i);
            else
                std::copy_n(field.material.data() + (first - field.first), count, out);
        },
        data_->field);
}

LabelCounts Volume::label_counts() const
{
    const Array<int64_t>& voxels = voxel_counts();
    return {Array<UserLabel>(labels().begin(), labels().end()), Array<int64_t>(voxels.begin(), voxels.end())};
}

const Array<int64_t>& Volume::voxel_counts() const
{
    // Not std::call_once(): where no memory is left, the C library ends the process when an exception passes through
    // it.
    const std::lock_guard<std::mutex> lock(data_->counting);
    if (data_->counts.empty())
        data_->counts = std::visit([&](const auto& field) { return counts_of(field, labels().size()); }, data_->field);
    return data_->counts;
}

Material Volume::material_at(const Vec3& x) const
{
    return std::visit([&](const auto& field) { return cleft::material_at(field, x); }, data_->field);
}

void Volume::sample(const Vec3& x, Samples& out) const
{
    std::visit([&](const auto& field) { cleft::sample(field, x, out); }, data_->field);
}

void Volume::sample_gradient(const Vec3& x, Samples& out) const
{
    std::visit([&](const auto& field) { cleft::sample_gradient(field, x, out); }, data_->field);
}

bool Volume::single_material_near(const Vec3& x, double reach) const
{
    return std::visit([&](const auto& field) { return cleft::single_material_near(field, x, reach); }, data_->field);
}

}  // namespace cleft
