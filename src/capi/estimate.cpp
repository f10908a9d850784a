// What a mesh will come to: tetrahedra and memory, before it is made.
#include "pipeline/estimate.hpp"

#include "base/struct_size.hpp"
#include "capi/firewall.hpp"
#include "capi/given_mesh.hpp"
#include "capi/mesh_frame.hpp"
#include "capi/options.hpp"

using namespace cleft::capi;
using cleft::Estimate;
using cleft::Run;

template <>
inline constexpr size_t cleft::kFirstSize<cleft_estimate> = CLEFT_END_OF(cleft_estimate, peak_bytes);

namespace
{

// What is given is held by the caller.
Estimate estimated(const cleft_volume& volume, const cleft_sizing* sizing, const cleft_mesh* background,
                   const cleft::PipelineOptions& p, const Run& run)
{
    if (background) {
        const GivenBackground given = given_background(*background, volume.frame, run);
        // A background decides over sizes, as it does in cleft_mesh_volume(), but follows a metric.
        if (given.is_ours || !sizing || !sizing->sizing.field.metric || p.repair_angle <= 0)
            return cleft::estimate_from_background(volume.volume, given.mesh, p, run);
        cleft::PipelineOptions without_search = p;
        without_search.tets = 0;
        return cleft::estimate_from_sizing(volume.volume, given_sizing(*sizing, volume), without_search, run);
    }
    if (sizing)
        return cleft::estimate_from_sizing(volume.volume, given_sizing(*sizing, volume), p, run);
    return cleft::estimate_from_volume(volume.volume, p, run);
}

}  // namespace

cleft_status cleft_mesh_estimate(cleft_context* context, const cleft_volume* volume, const cleft_sizing* sizing,
                                 const cleft_mesh* background, const cleft_options* options,
                                 cleft_estimate* out) noexcept
{
    return guarded_run(context, "estimate", [&](const Run& run) {
        const auto v = held(volume, "volume");
        const auto held_options = held_if_any(options, "options");
        const auto held_sizing = held_if_any(sizing, "sizing");
        const auto held_background = held_if_any(background, "background");
        // Before the work: a struct whose size was not set should not cost minutes first.
        cleft::check_struct_size(*required(out, "out"), "cleft_estimate");
        if (!sizing && !background)
            warn_of_unknown_sizes(v->volume.labels(), options, run);
        const Estimate found = estimated(*v, sizing, background, pipeline_options(options, *v), run);
        cleft::copy_out<cleft_estimate>({0, found.mesh.is_rough, found.mesh.kept_tets, found.mesh.whole_tets,
                                         found.mesh.background_tets, found.peak_bytes},
                                        *out);
        run.report(1, nullptr);
    });
}
