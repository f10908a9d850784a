// cleft mesh: from a volume to a mesh.
#include "commands.hpp"
#include "findings.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "option_arguments.hpp"
#include "output_conflicts.hpp"
#include "output_files.hpp"
#include "standard_output.hpp"
#include "summary.hpp"
#include "text.hpp"
#include "volume_arguments.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cleft_cli
{
namespace
{

// The table of labels then fits one screen with the rest of the summary.
constexpr std::size_t kLabelsShown = 20;

struct MeshArguments {
    VolumeArguments input;
    OptionArguments options;
    RunArguments run;
    std::vector<std::string> outputs;
    std::string msh_version = "4.1";
    std::string sizing_file;
    std::string background_file;
    bool combine = false;
    bool check = false;
    bool estimate = false;

    bool left_out(int32_t label) const { return options.leaves_out(label); }
};

// What is known when the mesh is done.
struct Result {
    VolumeFindings volume;
    MeshFindings mesh;
    ReportFindings report;  // contacts of kept labels only
    std::vector<OutputFile> outputs;
};

std::vector<OutputFile> checked_outputs(const MeshArguments& arguments)
{
    if (arguments.outputs.empty() && !arguments.estimate)
        throw usage_failure("--output is required (or --estimate)");
    std::vector<std::string> inputs = arguments.input.inputs;
    // Files that are read later are inputs, too: an output must not replace them.
    inputs.insert(inputs.end(), {arguments.sizing_file, arguments.background_file});
    refuse_conflicts(inputs, arguments.outputs, arguments.run.json);
    std::vector<OutputFile> outputs;
    for (const std::string& path : arguments.outputs)
        outputs.push_back(checked_mesh_output(path, arguments.msh_version));
    // A long run must not end with a report that cannot be written.
    check_json_output(arguments.run.json);
    return outputs;
}

Volume read_volume(Session& session, const MeshArguments& arguments, const cleft_options* options)
{
    Volume volume;
    session.timed("read", "reading the volume", [&] { volume = arguments.input.read(session, options); });
    return volume;
}

Sizing read_sizing(Session& session, const MeshArguments& arguments, const cleft_volume* volume,
                   const cleft_options* options)
{
    if (arguments.sizing_file.empty())
        return {};
    cleft_io_reading reading = arguments.input.reading();
    reading.scale = 1;  // the field is in the unit of the mesh, as `cleft sizing` writes it
    Sizing sizing;
    session.timed("read_sizing", "reading the sizing field", [&] {
        sizing = session.make<Sizing>(EXIT_CANNOT_READ, [&](cleft_sizing** out) {
            return cleft_io_read_sizing(session.context(), volume, arguments.sizing_file.c_str(), &reading,
                                        arguments.combine ? 1 : 0, options, out);
        });
    });
    return sizing;
}

Mesh read_background(Session& session, const std::string& path)
{
    if (path.empty())
        return {};
    Mesh background;
    session.timed("read_background", "reading the background", [&] {
        background = session.make<Mesh>(EXIT_CANNOT_READ, [&](cleft_mesh** out) {
            return cleft_io_read_mesh(session.context(), path.c_str(), out);
        });
    });
    return background;
}

int tell_estimate(Session& session, const MeshArguments& arguments, const cleft_volume* volume,
                  const cleft_sizing* sizing, const cleft_mesh* background, const cleft_options* options)
{
    cleft_estimate estimate{};
    estimate.struct_size = sizeof estimate;
    session.timed("estimate", "estimating", [&] {
        session.check(cleft_mesh_estimate(session.context(), volume, sizing, background, options, &estimate),
                      EXIT_MESHING_FAILED);
    });
    const VolumeFindings found = look_at_volume(session, volume);
    session.clear_progress();
    if (arguments.run.prints()) {
        std::string text = volume_line(found) + left("Estimate", 11) + (estimate.is_bound != 0 ? "up to " : "") +
                           rounded(estimate.tets) + " tetrahedra, about " + bytes_text(estimate.peak_bytes) +
                           " of memory\n";
        // Labels that are left out are meshed first and removed at the end, so they cost memory and
        // time.
        if (estimate.whole_tets > 1.01 * estimate.tets)
            text += left("", 11) + "of " + rounded(estimate.whole_tets) + " with the labels that are left out\n";
        print_summary_text(text);
    }
    if (!arguments.run.json.empty()) {
        auto report = report_head("mesh");
        report["volume"] = volume_json(found);
        report["estimate"] = {{"tets", estimate.tets},
                              {"whole_tets", estimate.whole_tets},
                              {"background_tets", estimate.background_tets},
                              {"peak_bytes", estimate.peak_bytes},
                              {"is_bound", estimate.is_bound != 0}};
        add_run(report, session);
        write_json(report, arguments.run.json);
    }
    return EXIT_OK;
}

// Looks at the mesh for what it finds, and validates it. It fills its box unless a label of the volume was left out of
// it, or the background is the user's.
MeshFindings checked_findings(Session& session, const MeshArguments& arguments, const cleft_volume* volume,
                              const cleft_mesh* mesh)
{
    bool whole = arguments.background_file.empty();
    for (int64_t i = 0; i < cleft_volume_label_count(volume); ++i)
        whole = whole && !arguments.left_out(cleft_volume_labels(volume)[i]);
    cleft_validation validation = {};
    validation.struct_size = sizeof validation;
    MeshFindings found;
    std::string fault;
    session.timed("check", "checking the mesh", [&] {
        session.check(cleft_mesh_validate(session.context(), mesh, whole ? 1 : 0, &validation), EXIT_MESHING_FAILED);
        // A broken mesh is not looked at further: its surface and angles may have no meaning.
        if (validation.valid == 0) {
            fault = cleft_context_last_error(session.context());
        } else {
            found = look_at_mesh(session, mesh);
            fault = surface_fault(validation, found);
        }
    });
    // It is not written, as somebody would use it all the same.
    if (!fault.empty())
        throw Failure(EXIT_CHECK_FAILED, CLEFT_ERROR_INVALID_MESH,
                      "the mesh is not valid, and was not written: " + fault);
    return found;
}

// The findings without the contacts of labels that are left out.
ReportFindings kept_contacts(const MeshArguments& arguments, ReportFindings found)
{
    auto& contacts = found.contacts;
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                  [&](const cleft_contact& contact) {
                                      return arguments.left_out(contact.first) || arguments.left_out(contact.second);
                                  }),
                   contacts.end());
    return found;
}

void warn_of_contacts(Session& session, const std::vector<cleft_contact>& contacts)
{
    // More pairs make the warning unreadable; all of them are in the JSON report.
    constexpr std::size_t kNamed = 5;
    if (contacts.empty())
        return;
    std::string pairs;
    for (std::size_t i = 0; i < std::min(contacts.size(), kNamed); ++i)
        pairs += (i == 0 ? "" : ", ") + std::to_string(contacts[i].first) + " and " +
                 std::to_string(contacts[i].second) + " (" + plural(contacts[i].triangles, "triangle") + ")";
    if (contacts.size() > kNamed)
        pairs += " and " + grouped(static_cast<int64_t>(contacts.size() - kNamed)) + " more";
    session.warn(plural(static_cast<int64_t>(contacts.size()), "pair") +
                 " of labels meet in the mesh, though no two of their voxels share a face or an edge: " + pairs +
                 "; a smaller size opens the gap (--size-min, --label-size)");
}

// Labels of which one thing is reported: five by name, and how many more there are.
class LabelList
{
public:
    void add(int32_t label, const std::string& what)
    {
        constexpr int64_t kNamed = 5;
        if (++count_ <= kNamed)
            text_ += (count_ == 1 ? "label " : ", label ") + std::to_string(label) + " (" + what + ")";
        else
            ++more_;
    }
    bool empty() const { return count_ == 0; }
    std::string text() const { return text_ + (more_ > 0 ? " and " + grouped(more_) + " more" : ""); }
    std::string counted() const { return plural(count_, "label"); }

private:
    int64_t count_ = 0, more_ = 0;
    std::string text_;
};

// Each kind of loss in one sentence, however many labels it befalls.
void warn_of_lost_labels(Session& session, const MeshArguments& arguments, const Result& result)
{
    LabelList lost, pieces_lost, broken;
    for (const LabelFindings& row : result.report.labels) {
        if (arguments.left_out(row.label))
            continue;
        const std::string of_pieces = " of " + plural(row.large_components, "piece");
        if (row.lost != 0)
            lost.add(row.label, plural(row.voxels, "voxel"));
        // A lost label has lost its pieces, too; one warning suffices.
        else if (row.large_components_lost > 0)
            pieces_lost.add(row.label, grouped(row.large_components_lost) + of_pieces);
        if (row.large_components_broken > 0)
            broken.add(row.label, grouped(row.large_components_broken) + of_pieces);
    }
    if (!lost.empty())
        session.warn("the mesh lacks " + lost.counted() + " of the volume: " + lost.text());
    if (!pieces_lost.empty())
        session.warn("the mesh lacks pieces of more than 30 voxels of " + pieces_lost.counted() + ": " +
                     pieces_lost.text());
    if (!broken.empty())
        session.warn("pieces of more than 30 voxels of " + broken.counted() +
                     " broke where they are thinner than the tetrahedra: " + broken.text() +
                     " (--size-min, --label-size)");
}

void print_summary(const Session& session, const MeshArguments& arguments, const Result& result,
                   const StagedOutputs& staged)
{
    const auto left_out = [&](int32_t label) { return arguments.left_out(label); };
    const std::size_t limit = arguments.run.verbose ? result.report.labels.size() : kLabelsShown;
    std::string text = volume_line(result.volume) + mesh_lines(result.mesh) + "\n" +
                       dihedral_histogram(result.mesh.quality) + "\n" +
                       label_report_table(result.report.labels, left_out, limit) + "\n";
    if (arguments.run.verbose)
        text += stages_table(session) + "\n";
    text += time_line(session, result.mesh.tets);
    for (const OutputFile& output : result.outputs) {
        // 0 where the file cannot be looked at.
        const double bytes = staged.bytes(output.path);
        text += left("Written", 11) + output.path + (bytes > 0 ? " (" + bytes_text(bytes) + ")" : "") + "\n";
    }
    print_summary_text(text);
}

void write_report(const Session& session, const MeshArguments& arguments, const cleft_options* options,
                  const Result& result, StagedOutputs& staged)
{
    auto report = report_head("mesh");
    report["inputs"] = arguments.input.inputs;
    report["outputs"] = arguments.outputs;
    report["world"] = arguments.input.world;
    report["options"] = arguments.options.as_json(options);
    // The option holds the name of a kind, and the run used the file instead.
    if (!arguments.background_file.empty())
        report["options"]["background"] = arguments.background_file;
    report["options"]["sizing"] = arguments.sizing_file;
    report["volume"] = volume_json(result.volume);
    report["mesh"] = mesh_json(result.mesh);
    report["quality"] = quality_json(result.mesh.quality);
    report["labels"] =
        label_reports_json(result.report.labels, [&](int32_t label) { return arguments.left_out(label); });
    report["contacts"] = contacts_json(result.report.contacts);
    add_run(report, session);
    write_json(report, arguments.run.json, staged);
}

int run_mesh(MeshArguments& arguments)
{
    // Before make(), which would refuse a path as a kind of background.
    arguments.background_file = arguments.options.take_background_file();
    const Options options = arguments.options.make();
    Result result;
    result.outputs = checked_outputs(arguments);
    Session session(arguments.run);

    Volume volume = read_volume(session, arguments, options.get());
    Sizing sizing = read_sizing(session, arguments, volume.get(), options.get());
    Mesh background = read_background(session, arguments.background_file);
    if (arguments.estimate)
        return tell_estimate(session, arguments, volume.get(), sizing.get(), background.get(), options.get());

    Mesh mesh;
    session.timed("mesh", "meshing", [&] {
        mesh = session.make<Mesh>(EXIT_MESHING_FAILED, [&](cleft_mesh** out) {
            return cleft_mesh_volume(session.context(), volume.get(), sizing.get(), background.get(), options.get(),
                                     out);
        });
    });
    // Fields and background are as large as the volume or the mesh. They are not needed any more,
    // and the report takes memory.
    sizing.reset();
    background.reset();
    if (arguments.check)
        result.mesh = checked_findings(session, arguments, volume.get(), mesh.get());
    // With --quiet and no report nobody sees the figures, so they are not computed.
    if (arguments.run.prints() || !arguments.run.json.empty()) {
        session.timed("report", "looking at the mesh", [&] {
            result.volume = look_at_volume(session, volume.get());
            if (!arguments.check)
                result.mesh = look_at_mesh(session, mesh.get());
            result.report = kept_contacts(arguments, look_at_labels(session, volume.get(), mesh.get()));
        });
        warn_of_lost_labels(session, arguments, result);
        warn_of_contacts(session, result.report.contacts);
    }
    // The voxels have been compared with the mesh. Writers need memory for the surface.
    volume.reset();
    StagedOutputs staged;
    session.timed("write", "writing", [&] { write_mesh(session, mesh.get(), result.outputs, staged); });

    session.clear_progress();
    if (!arguments.run.json.empty())
        write_report(session, arguments, options.get(), result, staged);
    if (arguments.run.prints())
        print_summary(session, arguments, result, staged);
    // Last of all: whatever fails before leaves no output and no part of one.
    staged.commit();
    return EXIT_OK;
}

std::string mesh_footer()
{
    return "Formats of OUTPUT, by extension:\n" + format_help(CLEFT_IO_WRITES_MESH) +
           "\nExamples:\n"
           "  cleft mesh atlas.nii.gz -o atlas.vtu --json atlas.json\n"
           "  cleft mesh head.nrrd -o head.msh -o skin.stl --strip 0 --tets 500000\n"
           "  cleft mesh head.nrrd -o head.inp --size-max 8 --label-size 3=1.5 --gradation 0.2\n"
           "  cleft mesh a.nrrd b.nrrd c.nrrd -o scene.vtu        indicator functions, the largest wins\n"
           "  cleft mesh voxels.raw --dims 256 256 256 --type uint8 --spacing 0.1 0.1 0.1 -o rock.vtu\n"
           "  cleft mesh head.nrrd --estimate                     how many tetrahedra, how much memory\n"
           "  cleft sizing head.nrrd -o h.nrrd; cleft mesh head.nrrd --sizing h.nrrd -o head.vtu\n\n" +
           exit_code_help();
}

}  // namespace

Command add_mesh_command(CLI::App& app)
{
    auto arguments = std::make_shared<MeshArguments>();
    CLI::App& parser = *app.add_subcommand("mesh", "Make a mesh of a volume");
    arguments->input.add_inputs_to(parser);
    parser
        .add_option("-o,--output", arguments->outputs,
                    "The mesh; may be repeated for several formats. Missing folders\n"
                    "and unknown extensions are refused before the work begins")
        ->allow_extra_args(false)
        ->type_name("OUTPUT");
    parser.add_option("--msh-version", arguments->msh_version, "Version of Gmsh's format for .msh (default 4.1)")
        ->check(CLI::IsMember({"4.1", "2.2"}).description(""))
        ->type_name("4.1|2.2");
    parser.add_flag("--check", arguments->check, "Validate the mesh before it is written; exit code 1 if it fails");
    parser.add_flag("--estimate", arguments->estimate,
                    "Tell the expected number of tetrahedra and the memory needed,\n"
                    "and stop there");
    arguments->options.add_to(parser, {"volume", "mesh"});
    arguments->options.add_label_sizes_to(parser);
    // The command also takes a file here; the table of the library knows the kinds only.
    parser.get_option("--background")->type_name("particles|lattice|octree|FILE");
    // --sizing and --combine are no options of the library, but belong among the sizes in help.
    const std::string sizes = parser.get_option("--size")->get_group();
    parser
        .add_option("--sizing", arguments->sizing_file,
                    "Your own sizing field: a volume on the same grid, with an edge\n"
                    "length for each voxel (see `cleft sizing`)")
        // The description would stand behind the type in the help.
        ->check(CLI::ExistingFile.description(""))
        ->type_name("FILE")
        ->group(sizes);
    parser
        .add_flag("--combine", arguments->combine, "With --sizing: take the smaller of your field and the computed one")
        ->group(sizes);
    arguments->options.add_label_lists_to(parser);
    arguments->input.add_reading_to(parser);
    arguments->run.add_to(parser);
    parser.footer(mesh_footer());
    return {&parser, [arguments] { return guarded("mesh", arguments->run, [&] { return run_mesh(*arguments); }); }};
}

}  // namespace cleft_cli
