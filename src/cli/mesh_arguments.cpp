// The options of `cleft mesh`, in the order of its help.
#include "mesh_arguments.hpp"

#include "exit_code.hpp"
#include "label_names.hpp"
#include "mesh_files.hpp"

#include <CLI/CLI.hpp>

namespace cleft_cli
{
namespace
{

std::string mesh_footer()
{
    return "Formats of OUTPUT, by extension:\n" + format_help(CLEFT_IO_WRITES_MESH) +
           "\nExamples:\n"
           "  cleft mesh atlas.nii.gz -o atlas.vtu --json atlas.json\n"
           "  cleft mesh head.nrrd -o head.vtu --view head.html   and look at it in a browser\n"
           "  cleft mesh aparc+aseg.nii.gz --names FreeSurferColorLUT.txt --strip 0 -o brain.vtu\n"
           "  cleft mesh head.nrrd -o head.msh -o skin.stl --strip 0 --tets 500000\n"
           "  cleft mesh head.nrrd -o head.inp --size-max 8 --label-size 3=1.5 --gradation 0.2\n"
           "  cleft mesh a.nrrd b.nrrd c.nrrd -o scene.vtu        indicator functions, the largest wins\n"
           "  cleft mesh voxels.raw --dims 256 256 256 --type uint8 --spacing 0.1 0.1 0.1 -o rock.vtu\n"
           "  cleft mesh head.nrrd --estimate                     how many tetrahedra, how much memory\n"
           "  cleft mesh flow.nrrd --metric metric.nrrd -o flow.vtu   sizes that depend on the direction\n"
           "  cleft sizing head.nrrd -o h.nrrd; cleft mesh head.nrrd --sizing h.nrrd -o head.vtu\n\n" +
           exit_code_help();
}

void add_results_to(CLI::App& parser, MeshArguments& arguments)
{
    parser
        .add_option("-o,--output", arguments.outputs,
                    "The mesh; may be repeated for several formats. Missing folders\n"
                    "and unknown extensions are refused before the work begins")
        ->allow_extra_args(false)
        ->type_name("OUTPUT");
    add_msh_version_to(parser, arguments.msh_version);
    parser
        .add_option("--view", arguments.view.output,
                    "A page that shows the mesh in any browser, with this run's report")
        ->type_name("FILE.html");
    add_names_to(parser, arguments.names, "Names of labels in the summary and in all files");
    parser.add_flag("--check", arguments.check, "Validate the mesh before it is written; exit code 1 if it fails");
    parser.add_flag("--distances", arguments.distances,
                    "Measure how far the interfaces of the mesh are from those of the\n"
                    "volume. It takes about half as long as meshing");
    parser.add_flag("--estimate", arguments.estimate,
                    "Tell the expected number of tetrahedra and the memory needed,\n"
                    "and stop there");
}

// --sizing and --combine are no options of the library, but belong among the sizes in help.
void add_sizing_field_to(CLI::App& parser, MeshArguments& arguments)
{
    const std::string sizes = parser.get_option("--size")->get_group();
    parser
        .add_option("--sizing", arguments.sizing_file,
                    "Your own sizing field: a volume on the same grid, with an edge\n"
                    "length for each voxel (see `cleft sizing`)")
        // The description would stand behind the type in the help.
        ->check(CLI::ExistingFile.description(""))
        ->type_name("FILE")
        ->group(sizes);
    arguments.metric.add_to(parser, kMetricHelp, sizes);
    parser.get_option("--metric")->excludes(parser.get_option("--sizing"));
    parser
        .add_flag("--combine", arguments.combine,
                  "With --sizing or --metric: no length is greater than that of the\n"
                  "computed field")
        ->group(sizes);
}

}  // namespace

// The shares are what AAL takes at the default options.
std::vector<Part> MeshArguments::parts() const
{
    std::vector<Part> all{{"read", 5}};
    const auto add = [&](bool is_wanted, const Part& part) {
        if (is_wanted)
            all.push_back(part);
    };
    add(!sizing_file.empty(), {"read_sizing", 2});
    add(metric.given(), {"read_metric", 2});
    add(!background_file.empty(), {"read_background", 5});
    add(estimate, {"estimate", 20});
    if (estimate)
        return all;
    all.push_back({"mesh", 80});
    add(metric.given() && has_report(), {"metric", 1});
    add(check, {"check", 5});
    add(has_report(), {"report", 1});
    add(has_report(), {"labels", distances ? 40.0 : 1.0});
    all.push_back({"write", 3});
    add(!view.output.empty(), {"view", 10});
    return all;
}

void MeshArguments::add_to(CLI::App& parser)
{
    input.add_inputs_to(parser);
    add_results_to(parser, *this);
    options.add_to(parser, {"volume", "mesh"});
    options.add_label_sizes_to(parser);
    // The command also takes a file here; the table of the library knows the kinds only.
    CLI::Option& background = *parser.get_option("--background");
    background.type_name(background.get_type_name() + "|FILE");
    add_sizing_field_to(parser, *this);
    options.add_label_lists_to(parser);
    input.add_reading_to(parser);
    run.add_to(parser);
    parser.footer(mesh_footer());
}

}  // namespace cleft_cli
