// The core: handles, meshes on each background, the stages one by one.
#include "faults/digest.hpp"
#include "faults/works.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace faults
{
namespace
{

constexpr int64_t dims[3] = {5, 4, 6};
constexpr size_t voxel_count = 5 * 4 * 6;
constexpr double affine[12] = {1, 0, 0, 10, 0, 1, 0, -20, 0, 0, 1.5, 30};

struct Voxels {
    std::array<uint8_t, voxel_count> labels{};
    std::array<float, voxel_count> inside{}, sizes{};
    std::array<float, 6 * voxel_count> tensors{};

    Voxels()
    {
        for (size_t v = 0; v < voxel_count; ++v) {
            const auto x = static_cast<int>(v % 5), y = static_cast<int>(v / 5 % 4), z = static_cast<int>(v / 20);
            const bool in = x > 0 && x < 4 && y > 0 && y < 3 && z > 0 && z < 4;
            labels[v] = in ? 7 : (z > 3 ? 3 : 0);
            inside[v] = in ? 1.0F : -1.0F - 0.1F * static_cast<float>(z);
            sizes[v] = 2.0F + 0.25F * static_cast<float>(x);
            const float tensor[6] = {0.1F + 0.03F * static_cast<float>(x), 0.02F, -0.01F, 0.15F, 0.03F, 0.4F};
            std::copy(tensor, tensor + 6, tensors.data() + 6 * v);
        }
    }
};
const Voxels voxels;

void expect(cleft_status status)
{
    if (status != CLEFT_OK)
        std::abort();  // nothing fails here
}

// The first failure of several calls.
class Steps
{
public:
    template <class Call>
    Steps& then(const Call& call)
    {
        if (status_ == CLEFT_OK)
            status_ = call();
        return *this;
    }
    cleft_status status() const { return status_; }

private:
    cleft_status status_ = CLEFT_OK;
};

// Ends with the scope.
template <class Handle, void destroy(Handle*)>
struct Own {
    Handle* handle = nullptr;
    Own() = default;
    ~Own() { destroy(handle); }
    Own(const Own&) = delete;
    Own& operator=(const Own&) = delete;
};
using OwnContext = Own<cleft_context, cleft_context_destroy>;
using OwnOptions = Own<cleft_options, cleft_options_destroy>;
using OwnVolume = Own<cleft_volume, cleft_volume_destroy>;
using OwnSizing = Own<cleft_sizing, cleft_sizing_destroy>;
using OwnMesh = Own<cleft_mesh, cleft_mesh_destroy>;
using OwnSurface = Own<cleft_surface, cleft_surface_destroy>;
using OwnReport = Own<cleft_report, cleft_report_destroy>;

cleft_status make_handles(Bench& bench)
{
    OwnContext context;
    OwnOptions options;
    OwnVolume labelled, functions;
    const void* fields[1] = {voxels.inside.data()};
    const int32_t strip[2] = {7, 3};
    int64_t counts[3];
    return Steps()
        .then([&] { return cleft_context_create(&context.handle); })
        .then([&] { return cleft_options_create(&options.handle); })
        .then([&] { return cleft_options_set_label_size(options.handle, 7, 0.5); })
        .then([&] { return cleft_options_set_strip(options.handle, strip, 2); })
        .then([&] { return cleft_options_set_text(options.handle, "background", "octree"); })
        .then([&] {
            return cleft_volume_create_labels(context.handle, CLEFT_TYPE_UINT8, voxels.labels.data(), dims, affine,
                                              options.handle, &labelled.handle);
        })
        .then([&] {
            return cleft_volume_set_label_name(labelled.handle, 7, "a name that is too long to be kept in place");
        })
        .then([&] { return cleft_volume_copy_voxel_counts(labelled.handle, counts, 3); })
        .then([&] {
            return cleft_volume_create_indicators(context.handle, CLEFT_TYPE_FLOAT32, fields, 1, dims, affine, nullptr,
                                                  &functions.handle);
        })
        .then([&] {
            bench.digest = digest(counts, 3);
            return CLEFT_OK;
        })
        .status();
}

// All that is asked of a mesh; its digest is left on the bench.
cleft_status look_at(Bench& bench, const cleft_mesh* mesh)
{
    OwnSurface surface;
    OwnReport report;
    cleft_quality quality{};
    cleft_validation validation{};
    quality.struct_size = sizeof quality;
    validation.struct_size = sizeof validation;
    return Steps()
        .then([&] { return cleft_surface_create(bench.context, mesh, &surface.handle); })
        .then([&] { return cleft_report_create(bench.context, bench.volume, mesh, &report.handle); })
        .then([&] { return cleft_mesh_quality(bench.context, mesh, &quality); })
        .then([&] { return cleft_mesh_validate(bench.context, mesh, 1, &validation); })
        .then([&] {
            if (!validation.valid)
                std::abort();
            bench.digest = digest_of(mesh) ^ digest(cleft_surface_interface_triangles(surface.handle),
                                                    3 * cleft_surface_interface_count(surface.handle));
            return CLEFT_OK;
        })
        .status();
}

cleft_status mesh_on(Bench& bench, int32_t background)
{
    OwnMesh mesh;
    return Steps()
        .then([&] { return cleft_options_set_integer(bench.options, CLEFT_OPTION_BACKGROUND, background); })
        .then([&] {
            return cleft_mesh_volume(bench.context, bench.volume, nullptr, nullptr, bench.options, &mesh.handle);
        })
        .then([&] { return look_at(bench, mesh.handle); })
        .status();
}

cleft_status mesh_to_a_number(Bench& bench)
{
    cleft_status status = cleft_options_set_integer(bench.options, CLEFT_OPTION_TETS, 181);
    return status != CLEFT_OK ? status : mesh_on(bench, CLEFT_BACKGROUND_LATTICE);
}

cleft_status mesh_on_own(Bench& bench)
{
    OwnMesh mesh;
    return Steps()
        .then([&] {
            return cleft_mesh_volume(bench.context, bench.volume, nullptr, bench.background, bench.options,
                                     &mesh.handle);
        })
        .then([&] { return look_at(bench, mesh.handle); })
        .status();
}

cleft_status mesh_functions(Bench& bench)
{
    OwnVolume functions;
    OwnMesh mesh;
    const void* fields[1] = {voxels.inside.data()};
    return Steps()
        .then([&] {
            return cleft_volume_create_indicators(bench.context, CLEFT_TYPE_FLOAT32, fields, 1, dims, affine, nullptr,
                                                  &functions.handle);
        })
        .then(
            [&] { return cleft_options_set_integer(bench.options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_OCTREE); })
        .then([&] {
            return cleft_mesh_volume(bench.context, functions.handle, nullptr, nullptr, bench.options, &mesh.handle);
        })
        .then([&] {
            bench.digest = digest_of(mesh.handle);
            return CLEFT_OK;
        })
        .status();
}

cleft_status size(Bench& bench)
{
    OwnSizing computed, constant, own;
    return Steps()
        .then([&] { return cleft_sizing_create(bench.context, bench.volume, bench.options, &computed.handle); })
        .then([&] { return cleft_sizing_create_constant(bench.context, bench.volume, 1, &constant.handle); })
        .then([&] {
            return cleft_sizing_create_values(bench.context, bench.volume, CLEFT_TYPE_FLOAT32, voxels.sizes.data(), 1,
                                              bench.options, &own.handle);
        })
        .then([&] {
            bench.digest = digest(cleft_sizing_values(computed.handle), static_cast<int64_t>(voxel_count)) ^
                           digest(cleft_sizing_values(own.handle), static_cast<int64_t>(voxel_count));
            return CLEFT_OK;
        })
        .status();
}

// Lengths that depend on the direction, to the end.
cleft_status mesh_by_a_metric(Bench& bench)
{
    OwnSizing constant, own;
    OwnMesh background, cleaved, improved;
    const double flat[6] = {0.1, 0, 0, 0.1, 0, 0.4};
    return Steps()
        .then([&] { return cleft_sizing_create_constant_metric(bench.context, bench.volume, flat, &constant.handle); })
        .then([&] {
            return cleft_sizing_create_metric(bench.context, bench.volume, CLEFT_TYPE_FLOAT32, voxels.tensors.data(), 1,
                                              bench.options, &own.handle);
        })
        .then([&] { return cleft_background_create(bench.context, own.handle, bench.options, &background.handle); })
        .then([&] {
            return cleft_mesh_cleave(bench.context, bench.volume, background.handle, bench.options, &cleaved.handle);
        })
        .then([&] {
            return cleft_mesh_improve(bench.context, bench.volume, cleaved.handle, bench.options, &improved.handle);
        })
        .then([&] { return look_at(bench, improved.handle); })
        .status();
}

cleft_status stages(Bench& bench)
{
    OwnMesh background, cleaved, improved, stripped;
    const int32_t strip[1] = {3};
    return Steps()
        .then([&] { return cleft_options_set_strip(bench.options, strip, 1); })
        .then([&] { return cleft_background_create(bench.context, bench.sizing, bench.options, &background.handle); })
        .then([&] {
            return cleft_mesh_cleave(bench.context, bench.volume, background.handle, bench.options, &cleaved.handle);
        })
        .then([&] {
            return cleft_mesh_improve(bench.context, bench.volume, cleaved.handle, bench.options, &improved.handle);
        })
        .then([&] { return cleft_mesh_strip(bench.context, improved.handle, bench.options, &stripped.handle); })
        .then([&] {
            bench.digest = digest_of(stripped.handle);
            return CLEFT_OK;
        })
        .status();
}

// Arrays out of a mesh, and a mesh out of them.
cleft_status copy(Bench& bench)
{
    OwnMesh again;
    static double points[3 * 20000];
    static int32_t tets[10 * 20000];
    int64_t count = 0;
    return Steps()
        .then([&] {
            return cleft_mesh_create(bench.context, cleft_mesh_point_count(bench.mesh), cleft_mesh_points(bench.mesh),
                                     cleft_mesh_tet_count(bench.mesh), cleft_mesh_tets(bench.mesh),
                                     cleft_mesh_tet_labels(bench.mesh), 0, &again.handle);
        })
        .then([&] { return cleft_mesh_set_label_name(again.handle, 7, "a name that is too long to be kept in place"); })
        .then([&] { return cleft_mesh_copy_quadratic(again.handle, 0, nullptr, 0, nullptr, 0, &count); })
        .then([&] { return cleft_mesh_copy_quadratic(again.handle, 0, points, 3 * 20000, tets, 10 * 20000, &count); })
        .then([&] {
            bench.digest = digest(points, 3 * count);
            return CLEFT_OK;
        })
        .status();
}

}  // namespace

Bench::Bench(int32_t threads)
{
    expect(cleft_context_create(&context));
    expect(cleft_context_set_threads(context, threads));
    expect(cleft_options_create(&options));
    expect(cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels.labels.data(), dims, affine, options, &volume));
    expect(cleft_sizing_create_constant(context, volume, 2, &sizing));
    expect(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_LATTICE));
    expect(cleft_background_create(context, sizing, options, &background));
    expect(cleft_mesh_volume(context, volume, sizing, background, options, &mesh));
    expect(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_PARTICLES));
}

Bench::~Bench()
{
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

std::vector<Work> core_works()
{
    std::vector<Work> works = {{"handles", make_handles},
                               {"sizing", size},
                               {"copy", copy},
                               {"own background", mesh_on_own},
                               {"functions", mesh_functions}};
    // A search makes the mesh of "lattice" three times. Each trial looks at thousands of places for its first guess.
    Work search{"number", mesh_to_a_number};
    search.step = 17;
    works.push_back(search);
    for (int32_t threads = 1; threads <= 2; ++threads) {
        const std::string on = threads == 1 ? "" : ", 2 threads";
        works.push_back({"octree" + on, [](Bench& b) { return mesh_on(b, CLEFT_BACKGROUND_OCTREE); }, {}, threads});
        works.push_back({"lattice" + on, [](Bench& b) { return mesh_on(b, CLEFT_BACKGROUND_LATTICE); }, {}, threads});
        works.push_back(
            {"particles" + on, [](Bench& b) { return mesh_on(b, CLEFT_BACKGROUND_PARTICLES); }, {}, threads});
        works.push_back({"stages" + on, stages, {}, threads});
        works.push_back({"metric" + on, mesh_by_a_metric, {}, threads});
    }
    return works;
}

}  // namespace faults
