// The entries that make meshes from volumes: background, cleaving, improving, stripping, and all at once.
#include "capi/firewall.hpp"
#include "capi/given_mesh.hpp"
#include "capi/kept_labels.hpp"
#include "capi/mesh_frame.hpp"
#include "capi/options.hpp"
#include "checking/quick_check.hpp"
#include "pipeline/pipeline.hpp"

#include <algorithm>
#include <utility>

using namespace cleft::capi;
using cleft::Error;
using cleft::LabelledMesh;
using cleft::Run;

namespace
{

// A mesh of a volume, under the volume's labels and their names.
cleft_mesh to_user(LabelledMesh&& mesh, const cleft_volume& volume, const Run& run)
{
    cleft_mesh out = cleft::capi::to_user(std::move(mesh), volume.frame, volume.volume.labels(), run);
    add_label_names(out.names, volume.names, out.labels);
    return out;
}

// What is left of a sound mesh is sound.
// So strip checks its input quickly, and not its result.
void require_sound(const cleft::UserMesh& mesh, const Run& run)
{
    const std::string fault = cleft::quick_fault(mesh.points, mesh.tets, run);
    if (!fault.empty())
        throw Error(CLEFT_ERROR_INVALID_MESH, "the mesh is not valid: " + fault);
}

// Of what the caller gets, without the labels that are left out.
void note_result(const Run& run, const cleft::UserMesh& mesh)
{
    run.note("mesh.points", static_cast<double>(mesh.points.size()));
    run.note("mesh.tets", static_cast<double>(mesh.tets.size()));
}

// The search for a number is over when a background is made: it belongs to the sizes.
void warn_of_unmet_number(const cleft::ScaledSizing& sizing, int64_t tets, const Run& run)
{
    if (tets > 0 && sizing.found_for != tets)
        run.warn("tets is " + std::to_string(tets) + " and has no effect: the sizing field was made " +
                 (sizing.found_for > 0 ? "with " + std::to_string(sizing.found_for) : "without it"));
}

// The field whose metric a background of the user is to follow; null if there is none.
const cleft::SizingField* metric_to_follow(const GivenBackground& background, const cleft_sizing* sizing,
                                           const cleft_volume& volume, const Run& run)
{
    if (!sizing)
        return nullptr;
    require_same_grid(*sizing, volume);
    if (!background.is_ours && sizing->sizing.field.metric)
        return &sizing->sizing.field;
    run.warn("the sizing field has no effect on a background that is given");
    return nullptr;
}

// A background decides over the sizes of a field.
LabelledMesh meshed_from(const cleft_mesh& background, const cleft_sizing* sizing, const cleft_volume& volume,
                         const cleft::PipelineOptions& p, const Run& run)
{
    // The option may be left from another call of the same handle, so this is no error. But the number will not be met.
    if (p.tets > 0)
        run.warn("tets has no effect on a background that is given");
    GivenBackground from = given_background(background, volume.frame, run);
    const cleft::SizingField* field = metric_to_follow(from, sizing, volume, run);
    const auto& metric = field ? field->metric : background.metric;
    return cleft::mesh_from_background(volume.volume, std::move(from.mesh), field,
                                       cleft::measured_by(metric.get(), from.options(p)), run);
}

// What is given is held by the caller.
LabelledMesh meshed(const cleft_volume& volume, const cleft_sizing* sizing, const cleft_mesh* background,
                    const cleft::PipelineOptions& p, const Run& run)
{
    if (background)
        return meshed_from(*background, sizing, volume, p, run);
    // A field that is given is complete: the options on sizes were applied when it was made.
    if (sizing)
        return cleft::mesh_from_sizing(volume.volume, given_sizing(*sizing, volume), p, run);
    return cleft::mesh_from_volume(volume.volume, p, run);
}

}  // namespace

cleft_status cleft_background_create(cleft_context* context, const cleft_sizing* sizing, const cleft_options* options,
                                     cleft_mesh** out) noexcept
{
    return guarded_create(context, out, "background", [&](const Run& run) {
        const auto s = held(sizing, "sizing");
        const cleft::PipelineOptions p = pipeline_options(options);
        warn_of_unmet_number(s->sizing, p.tets, run);
        cleft::TetMesh mesh = cleft::make_background(s->sizing, p, run);
        LabelledMesh labelled{std::move(mesh.points), std::move(mesh.tets), {}};
        // A background is a mesh like others to a caller, who may look at it or write it: it needs a label.
        labelled.material.assign(labelled.tets.size(), 0);
        // The handle keeps the points of the stage as well, for cleaving to go on from them.
        cleft_mesh result =
            to_next_stage(std::move(labelled), MadeBy::background, s->frame, {cleft::UserLabel{0}}, run);
        result.metric = s->sizing.field.metric;
        return result;
    });
}

cleft_status cleft_mesh_cleave(cleft_context* context, const cleft_volume* volume, const cleft_mesh* background,
                               const cleft_options* options, cleft_mesh** out) noexcept
{
    return guarded_create(context, out, "cleaving", [&](const Run& run) {
        const auto v = held(volume, "volume");
        const auto from = held(background, "background");
        const auto held_options = held_if_any(options, "options");
        const cleft::PipelineOptions p = pipeline_options(options, v->frame);
        warn_of_unused_smooth(v->volume, options, run);
        GivenBackground given = given_background(*from, v->frame, run);
        const cleft::PipelineOptions measured = cleft::measured_by(from->metric.get(), given.options(p));
        LabelledMesh cleaved = cleft::repair_and_cleave(v->volume, std::move(given.mesh), measured, run);
        cleft_mesh result = to_next_stage(std::move(cleaved), MadeBy::cleaving, v->frame, v->volume.labels(), run);
        result.metric = from->metric;
        add_label_names(result.names, v->names, result.labels);
        return result;
    });
}

cleft_status cleft_mesh_improve(cleft_context* context, const cleft_volume* volume, const cleft_mesh* mesh,
                                const cleft_options* options, cleft_mesh** out) noexcept
{
    return guarded_create(context, out, "improving", [&](const Run& run) {
        const auto v = held(volume, "volume");
        const auto from = held(mesh, "mesh");
        const auto held_options = held_if_any(options, "options");
        const cleft::PipelineOptions p = pipeline_options(options, *v);
        warn_of_unused_smooth(v->volume, options, run);
        // A mesh of a file, or one that the caller has changed, is checked as a whole: improving relies on all of it.
        if (!is_as_left(*from, MadeBy::cleaving, v->frame))
            require_valid(*from, "mesh", run);
        // The caller's handle holds the cleaved mesh, so further tries copy it instead of cleaving again.
        const cleft::Cleaved cleaved = [&](const Run& of_try) { return to_stage(*from, *v, of_try); };
        const cleft::PipelineOptions measured = cleft::measured_by(from->metric.get(), p);
        cleft_mesh result = cleft::capi::to_user(cleft::improve_and_finish(v->volume, cleaved, measured, run), v->frame,
                                                 v->volume.labels(), run);
        result.metric = from->metric;
        // Names on the mesh come first: the caller gave them later than those of the volume.
        add_label_names(result.names, from->names, result.labels);
        add_label_names(result.names, v->names, result.labels);
        return result;
    });
}

cleft_status cleft_mesh_strip(cleft_context* context, const cleft_mesh* mesh, const cleft_options* options,
                              cleft_mesh** out) noexcept
{
    return guarded_create(context, out, "stripping", [&](const Run& run) {
        const auto from = held(mesh, "mesh");
        // Stripping by no list would be a copy, so that NULL is a mistake here and no default.
        const auto lists = held(options, "options");
        require_sound(from->mesh, run);
        cleft_mesh copy = *from;
        // The points of its stage do not fit any more, so improving must check what it gets.
        copy.made_by = MadeBy::user;
        copy.local = {};
        strip_labels(copy, &*lists);
        warn_of_unknown_labels(user_labels(from->labels.data(), from->labels.count()), &*lists, "mesh", run);
        return copy;
    });
}

cleft_status cleft_mesh_volume(cleft_context* context, const cleft_volume* volume, const cleft_sizing* sizing,
                               const cleft_mesh* background, const cleft_options* options, cleft_mesh** out) noexcept
{
    return guarded_create(context, out, "mesh", [&](const Run& run) {
        const auto v = held(volume, "volume");
        const auto held_options = held_if_any(options, "options");
        const auto held_sizing = held_if_any(sizing, "sizing");
        const auto held_background = held_if_any(background, "background");
        const cleft::PipelineOptions p = pipeline_options(options, *v);
        // Warnings on options come before the minutes of work, so that a caller can cancel.
        warn_of_unknown_labels(v->volume.labels(), options, "volume", run);
        if (!sizing && !background)
            warn_of_unknown_sizes(v->volume.labels(), options, run);
        warn_of_unused_smooth(v->volume, options, run);
        LabelledMesh mesh = meshed(*v, sizing, background, p, run);
        cleft_mesh result = to_user(std::move(mesh), *v, run);
        note_result(run, result.mesh);
        return result;
    });
}
