// What the opaque handles of the C interface hold. Each begins with a mark of its kind, so that a handle of another
// kind is met with a status rather than with a crash, and with the number of its owners: the user, and the calls that
// work with it. A handle that a callback destroys so lives until the call that uses it ends.
#pragma once

#include "cleft/cleft_parts.h"

#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/metrics.hpp"
#include "capi/label_names.hpp"
#include "capi/occupancy.hpp"
#include "capi/option_table.hpp"
#include "checking/surface_distances.hpp"
#include "mesh/interfaces.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/user_label.hpp"
#include "parts/mesh_part.hpp"
#include "parts/part_labels.hpp"
#include "pipeline/label_report.hpp"
#include "pipeline/scaled_sizing.hpp"
#include "volume/frame.hpp"
#include "volume/volume.hpp"

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <utility>

namespace cleft::capi
{

// Values that memory hardly holds by chance. A mark is the first member of each handle: component.cpp reads it before
// it knows the kind.
enum class Mark : uint32_t {
    dead = 0,
    context = 0xC1EF0001,
    options = 0xC1EF0002,
    volume = 0xC1EF0003,
    sizing = 0xC1EF0004,
    mesh = 0xC1EF0005,
    surface = 0xC1EF0006,
    report = 0xC1EF0007,
    part = 0xC1EF0008
};

// How many own a handle. A copy of a handle has an owner of its own.
// Atomic, since immutable handles may be read and destroyed on several threads.
struct Owners {
    std::atomic<int32_t> count{1};
    Owners() = default;
    Owners(const Owners&) noexcept {}
    Owners& operator=(const Owners&) noexcept { return *this; }
};

// Which stage made a mesh that another goes on with: it need not be checked, and is worked on as it left that stage.
enum class MadeBy { user, background, cleaving };

// A base of all, without virtual functions, so that the mark is at the beginning of each.
template <Mark kind>
struct Handle {
    static constexpr Mark kMark = kind;
    Mark mark = kind;
    mutable Owners owners;
};

// One sentence. Not a std::string: telling of want of memory must not need memory.
// Its length holds every sentence with a long path in it; what is longer is cut.
using Message = std::array<char, 1024>;

}  // namespace cleft::capi

struct cleft_context : cleft::capi::Handle<cleft::capi::Mark::context> {
    int32_t threads = 1;
    cleft_progress_callback progress = nullptr;
    void* progress_user = nullptr;
    cleft_log_callback log = nullptr;
    void* log_user = nullptr;
    std::atomic<bool> cancel{false};
    double part_begin = 0, part_end = 1;  // of a component's call, which the calls within it are
    cleft::capi::Occupancy occupancy;
    cleft::Array<cleft::Array<const void*>> kept;  // handles that components keep alive, a list for each call of theirs
    // They stay from call to call, so that a caller can run all stages and read their figures at the end.
    cleft::Metrics metrics;
    cleft::capi::Message message{};
};

struct cleft_options : cleft::capi::Handle<cleft::capi::Mark::options> {
    cleft::FixedArray<double, cleft::capi::kOptionCount> values{};
    cleft::FixedArray<bool, cleft::capi::kOptionCount> given{};  // whether the user set it
    // In the order in which they were set; sizes are combined by minimum, so the order does not matter.
    cleft::Array<std::pair<cleft::UserLabel, double>> label_sizes;
    cleft::Array<cleft::UserLabel> strip;
    cleft::Array<cleft::UserLabel> only;
    cleft::capi::Message message{};
};

struct cleft_volume : cleft::capi::Handle<cleft::capi::Mark::volume> {
    cleft::Frame frame;
    cleft::Volume volume;
    cleft::Array<cleft::Material> listed;  // Volume::listed
    // Lists for callers are kept in the handle: their functions lend a pointer, which must live as long as it.
    cleft::Array<int32_t> labels;  // the numbers of the labels of these
    cleft::capi::LabelNames names;
};

struct cleft_sizing : cleft::capi::Handle<cleft::capi::Mark::sizing> {
    cleft::Frame frame;
    cleft::ScaledSizing sizing;
    double expected_tets = 0;  // of a background, in the labels that the options keep
};

struct cleft_mesh : cleft::capi::Handle<cleft::capi::Mark::mesh> {
    // None in a mesh of arrays, which knows no volume.
    std::optional<cleft::Frame> frame;  // of the volume or sizing field that it came from
    cleft::capi::MadeBy made_by = cleft::capi::MadeBy::user;
    cleft::Array<cleft::Vec3> local;  // a stage's own points for the next one, if the way back differs in last digits
    // That the stage's lengths and shapes are measured by, for the next stages too; null: by none.
    std::shared_ptr<const cleft::MetricField> metric;
    cleft::UserMesh mesh;
    cleft::Array<int32_t> labels;  // the different numbers, ascending
    cleft::capi::LabelNames names;
};

struct cleft_surface : cleft::capi::Handle<cleft::capi::Mark::surface> {
    cleft::Interfaces interfaces;  // whose regions are labels
};

struct cleft_report : cleft::capi::Handle<cleft::capi::Mark::report> {
    cleft::LabelReport report;
    cleft::Array<cleft::SurfaceDistances> distances;  // in the order in which users see them
    cleft::Array<cleft::Material> listed;             // the material of each row that users see
};

struct cleft_part : cleft::capi::Handle<cleft::capi::Mark::part> {
    cleft_part_counts counts{};
    cleft::MeshPart part;  // in the world, with labels in the place of materials
    // Of the part's triangles.
    cleft::Array<cleft::Triangle> triangles;
    cleft::Array<std::array<int32_t, 2>> triangle_labels;
    cleft::Array<int32_t> triangle_sides;
    cleft::Array<cleft::PartLabel> labels;  // of the whole mesh, in the world, in the order in which users see them
};
