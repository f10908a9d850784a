// The order of the stages, written once. The one call and the calls of single stages both come here, so they cannot
// drift apart.
#include "pipeline/pipeline.hpp"

#include "background/metric_background.hpp"
#include "background/repair.hpp"
#include "base/counted.hpp"
#include "base/number_text.hpp"
#include "base/stage.hpp"
#include "blocks/block_particles.hpp"
#include "blocks/block_sizes.hpp"
#include "blocks/mesh_blocks.hpp"
#include "finishing/finish.hpp"
#include "mesh/materials.hpp"
#include "mesh/order.hpp"
#include "mesh/strip.hpp"
#include "pipeline/label_report.hpp"
#include "pipeline/number_search.hpp"
#include "sizing/anisotropic_sizing.hpp"
#include "sizing/metric_sizing.hpp"
#include "sizing/volume_sizing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cleft
{

namespace
{

// Refuses to give back a mesh in which a kept label, or a large piece of one, is lost or broken, or touches another
// that it does not touch in the volume.
void require_all_labels(const Volume& volume, const LabelledMesh& mesh, const PipelineOptions& options, const Run& run)
{
    const LabelReport report = label_report(volume, mesh, run);
    const auto name = [&](Material m) { return name_of(volume.labels()[m]); };
    const std::string piece = " has a piece of more than " + std::to_string(kLargeComponent) + " voxels ";
    for (Material m = 0; m < volume.material_count(); ++m) {
        const LabelRow& row = report.rows[m];
        if (!options.kept.has(m))
            continue;
        if (row.voxels > 0 && row.tets == 0)
            throw Error(CLEFT_ERROR_LABEL_LOST, name(m) + " (" + counted(row.voxels, "voxel") +
                                                    ") has no tetrahedron; a smaller size would keep it");
        if (row.large_components_lost > 0)
            throw Error(CLEFT_ERROR_LABEL_LOST,
                        name(m) + piece + "without a tetrahedron; a smaller size would keep it");
        if (row.large_components_broken > 0)
            throw Error(CLEFT_ERROR_LABEL_LOST, name(m) + piece + "that broke; a smaller size would keep it whole");
    }
    for (const LabelContact& contact : report.contacts)
        if (options.kept.has(contact.first) && options.kept.has(contact.second))
            throw Error(CLEFT_ERROR_LABEL_LOST, name(contact.first) + " and " + name(contact.second) + " share " +
                                                    counted(contact.triangles, "triangle") +
                                                    ", but no two of their voxels share a face or an edge; a "
                                                    "smaller size would keep them apart");
}

// Of a background of the user.
void repair_background(TetMesh& background, const SizingField* adapted_to, const PipelineOptions& options,
                       const Run& run)
{
    // 0 stands for a background that is to be cleaved exactly as the user made it.
    if (options.repair_angle <= 0)
        return;
    Stage stage(run, "background", {{"background", 1}});
    if (adapted_to) {
        adapt_to_metric(background, *adapted_to, stage.next());
        return;
    }
    RepairOptions repair_options;
    repair_options.target_angle = options.repair_angle;
    repair_options.sweeps = 0;  // a user's points stay where they are unless a bad tetrahedron needs them moved
    repair(background, repair_options, stage.next());
}

LabelledMesh finished(const Volume& volume, LabelledMesh mesh, const PipelineOptions& options, const Run& run)
{
    Stage stage(run, "finish", {{nullptr, 1}});
    // Before anything is reported: the sentence of this error says more than warnings about an empty mesh.
    require_kept(kept_tets(mesh, options.kept));
    if (options.strict)
        require_all_labels(volume, mesh, options, run);
    if (run.on_warning)
        warn_of_volume_differences(volume.grid(), volume.label_counts(),
                                   material_volumes(mesh, volume.material_count(), run), options.kept, run);
    if (tells_of_missed_goal(options, 1, run))
        warn_of_missed_goal(missed_goal(mesh, options, run), volume.grid(), options, run);
    // Last, since stages before number points as they make them. It changes no place, so what was reported stays true.
    order_spatially(mesh, stage.next());
    return mesh;
}

// Meshes that a search makes take by far the most of the time.
Steps steps_of_sizing(const PipelineOptions& options, const Run& run)
{
    return Steps(run, {{nullptr, 1}, {nullptr, options.tets > 0 ? 20.0 : 0}});
}

// The field, scaled by meshing to the number that the options want.
ScaledSizing scaled(const Volume& volume, SizingField field, const PipelineOptions& options, const Run& run)
{
    ScaledSizing sizing{std::move(field)};
    if (options.tets > 0)
        mesh_of_number(volume, sizing, options, run);
    return sizing;
}

// The last stages of the one call. The tetrahedra of labels that are left out were there until here, since topology,
// volumes and angles need the neighbours of what stays.
LabelledMesh finished_and_stripped(const Volume& volume, LabelledMesh mesh, const PipelineOptions& options,
                                   const Run& run)
{
    LabelledMesh whole = finished(volume, std::move(mesh), options, run);
    if (!options.kept.all())
        strip(whole.points, whole.tets, whole.material, [&](Material m) { return options.kept.has(m); });
    return whole;
}

}  // namespace

namespace
{

SizingField anisotropic_sizes_of(const Volume& volume, const SizingOptions& options, BackgroundKind kind,
                                 const Run& run)
{
    if (kind != BackgroundKind::particles)
        throw Error(CLEFT_ERROR_OPTION, "an anisotropy above 1 needs the particles background");
    if (options.size > 0) {
        run.warn("anisotropy has no effect on a size that is given for all places");
        return compute_sizing(volume, options, run);
    }
    SizingField field = anisotropic_sizing(volume, options, run);
    const double expected = expected_particle_tets(field);
    if (options.max_tets > 0 && options.size_min <= 0 && expected > options.max_tets) {
        const double factor = std::cbrt(expected / options.max_tets);
        scale_sizing(field, factor, run);
        run.warn("the metric of the features asks for about " + count_text(expected) +
                 " tetrahedra: its sizes were made " + digits_text(factor, 3) +
                 " times as large to keep to max_tets, " + count_text(options.max_tets));
    }
    return field;
}

TetMesh background_of(const SizingField& field, const PipelineOptions& options, const Run& run)
{
    if (field.metric)
        return metric_background(field, options.background, run);
    const BlockLayout layout = BlockLayout::of(field.grid, options.block);
    if (layout.count > 1 && options.background.kind == BackgroundKind::particles &&
        have_room_for_particles(layout, field.range()))
        return particles_in_blocks(field, layout, options.background.particles, run);
    return row_of(options.background.kind).make(field, options.background, run);
}

}  // namespace

SizingField sizes_of(const Volume& volume, const PipelineOptions& options, const Run& run)
{
    SizingOptions sizing = options.sizing;
    sizing.expected_tets = row_of(options.background.kind).tets_near_limit;
    if (!sizing.expected_tets)
        sizing.max_tets = 0;
    if (sizing.anisotropy > 1)
        return anisotropic_sizes_of(volume, sizing, options.background.kind, run);
    const BlockLayout layout = BlockLayout::of(volume.grid(), options.block);
    if (layout.count > 1 && volume.is_label_map()) {
        Exchange alone = Exchange::alone();
        const BlockField field = sizes_of_own_blocks(parts_of(volume), layout, options, alone, run);
        return {volume.grid(), field.values(field.planes()), field.gradation()};
    }
    return compute_sizing(volume, sizing, run);
}

ScaledSizing make_sizing(const Volume& volume, const PipelineOptions& options, const Run& run)
{
    Steps steps = steps_of_sizing(options, run);
    SizingField field = sizes_of(volume, options, steps.next());
    return scaled(volume, std::move(field), options, steps.next());
}

ScaledSizing make_sizing(const Volume& volume, SizingField given, bool is_combined, PipelineOptions options,
                         const Run& run)
{
    Steps steps = steps_of_sizing(options, run);
    const Run first = steps.next();
    given.gradation = options.sizing.gradation;  // by which a search for a number scales it
    if (is_combined && given.metric) {
        intersect_metric(given, sizes_of(volume, options, first), first);
    } else if (is_combined) {
        // The old field is read until the new one is complete; the assignment comes after that.
        options.sizing.user = given.h.data();
        given = sizes_of(volume, options, first);
    }
    return scaled(volume, std::move(given), options, steps.next());
}

TetMesh make_background(const ScaledSizing& sizing, const PipelineOptions& options, const Run& run)
{
    Stage stage(run, "background", {{"background", 1}});
    const Run part = stage.next();
    if (!is_graded(options.background.kind))
        warn_of_coarse_lattice(sizing.field, sizing.scale, part);
    TetMesh mesh = background_of(sizing.field, options, part);
    run.note("background.points", static_cast<double>(mesh.points.size()));
    run.note("background.tets", static_cast<double>(mesh.tets.size()));
    return mesh;
}

LabelledMesh repair_and_cleave(const Volume& volume, TetMesh background, const PipelineOptions& options, const Run& run)
{
    Steps steps(run, {{nullptr, 3}, {nullptr, 7}});
    repair_background(background, nullptr, options, steps.next());
    return cleave(volume, background, options.cleave, steps.next());
}

LabelledMesh cleave_improve_and_fit(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                    const Run& run)
{
    // Improving may ask for it again, and holds no copy of it meanwhile.
    if (BlockLayout::of(volume.grid(), options.block).count > 1)
        return mesh_in_blocks(volume, background, options, run);
    const Cleaved cleaved = [&](const Run& part) { return cleave(volume, background, options.cleave, part); };
    return improve_and_fit(volume, cleaved, options, run);
}

LabelledMesh improve_and_finish(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options,
                                const Run& run)
{
    Steps steps(run, {{nullptr, 90}, {nullptr, 10}});
    LabelledMesh mesh = improve_and_fit(volume, cleaved, options, steps.next());
    return finished(volume, std::move(mesh), options, steps.next());
}

LabelledMesh mesh_from_volume(const Volume& volume, const PipelineOptions& options, const Run& run)
{
    // A wanted number takes some more meshes where the first has not met it.
    Steps steps(run, {{nullptr, 13}, {nullptr, options.tets > 0 ? 110.0 : 87}});
    ScaledSizing sizing{sizes_of(volume, options, steps.next())};
    return mesh_from_sizing(volume, std::move(sizing), options, steps.next());
}

LabelledMesh mesh_from_sizing(const Volume& volume, ScaledSizing sizing, const PipelineOptions& options, const Run& run)
{
    if (options.tets > 0) {
        Steps steps(run, {{nullptr, 95}, {nullptr, 5}});
        LabelledMesh mesh = mesh_of_number(volume, sizing, options, steps.next());
        if (!is_graded(options.background.kind))
            warn_of_coarse_lattice(sizing.field, sizing.scale, run);
        const std::shared_ptr<const MetricField> metric = sizing.field.metric;
        sizing = ScaledSizing();
        return finished_and_stripped(volume, std::move(mesh), measured_by(metric.get(), options), steps.next());
    }
    const double share = row_of(options.background.kind).share_of_time;
    Steps steps(run, {{nullptr, share}, {nullptr, 97 - share}, {nullptr, 3}});
    TetMesh background = make_background(sizing, options, steps.next());
    // Only the background needs the sizes, and a metric is needed to the end. Freed here, their memory is there for
    // cleaving.
    const std::shared_ptr<const MetricField> metric = sizing.field.metric;
    sizing = ScaledSizing();
    const PipelineOptions measured = measured_by(metric.get(), options);
    LabelledMesh mesh = cleave_improve_and_fit(volume, background, measured, steps.next());
    background = TetMesh();
    return finished_and_stripped(volume, std::move(mesh), measured, steps.next());
}

LabelledMesh mesh_from_background(const Volume& volume, TetMesh background, const SizingField* adapted_to,
                                  const PipelineOptions& options, const Run& run)
{
    Steps steps(run, {{nullptr, adapted_to ? 60.0 : 20.0}, {nullptr, 75}, {nullptr, 5}});
    repair_background(background, adapted_to, options, steps.next());
    LabelledMesh mesh = cleave_improve_and_fit(volume, background, options, steps.next());
    background = TetMesh();
    return finished_and_stripped(volume, std::move(mesh), options, steps.next());
}

}  // namespace cleft
