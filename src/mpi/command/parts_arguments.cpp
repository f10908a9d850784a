// The options of `cleft-mpi mesh`: those of `cleft mesh` that a mesh in parts has, and few others.
#include "mpi/command/parts_arguments.hpp"

#include "cli/output_conflicts.hpp"
#include "cli/output_files.hpp"
#include "cli/staged_outputs.hpp"
#include "mpi/piece_names.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace cleft_mpi_cli
{
namespace
{

const std::vector<std::string> kHdf5Extensions = {".h5", ".hdf5", ".hdf"};
const std::vector<std::string> kPartsExtensions = {".vtkhdf", ".hdf", ".pvtu", ".mfem"};

bool has_extension_of(const std::string& path, const std::vector<std::string>& extensions)
{
    const std::string extension = CLI::detail::to_lower(std::filesystem::path(path).extension().string());
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

const char* parts_footer()
{
    return "Formats of OUTPUT, by extension:\n"
           "  .vtkhdf, .hdf               VTKHDF: one file, the same for every number of ranks\n"
           "  .pvtu                       VTK XML: a piece for each rank, and a list of them\n"
           "  .mfem                       MFEM: a part for each rank, such as rock.mfem.000003\n"
           "\nExamples:\n"
           "  mpirun -n 8 cleft-mpi mesh rock.h5 -o rock.vtkhdf\n"
           "  mpirun -n 4 cleft-mpi mesh rock.h5 --dataset /scan/labels --spacing 2 2 2 -o rock.pvtu\n";
}

// Unlike in cleft, where nobody shares the work.
std::string with_default_block(std::string help)
{
    const std::string of_cleft = "default 0)";
    const std::size_t at = help.rfind(of_cleft);
    return help.replace(at, of_cleft.size(), "default:\n0 for less than 64 planes, else 32 or a sixteenth of them)");
}

}  // namespace

void PartsArguments::add_to(CLI::App& parser)
{
    parser
        .add_option("INPUT", volume.inputs,
                    "A label map whose voxels lie uncompressed in one file (NRRD, NIfTI,\n"
                    "MetaImage, VTK legacy, raw), or an HDF5 file")
        ->required()
        ->expected(1)
        ->type_name("");
    parser
        .add_option("-o,--output", outputs,
                    "The mesh; may be repeated for several formats. Missing folders\n"
                    "and unknown extensions are refused before the work begins")
        ->required()
        ->allow_extra_args(false)
        ->type_name("OUTPUT");
    add_sharing_to(parser);
    options.add_to(parser, {"volume", "mesh"});
    CLI::Option* const block = parser.get_option("--block");
    block->description(with_default_block(block->get_description()));
    options.add_label_sizes_to(parser);
    options.add_label_lists_to(parser);
    parser
        .add_option("--dataset", dataset,
                    "The path of the label map in an HDF5 file. Default: the only data\n"
                    "set with three dimensions and integers at the root")
        ->type_name("PATH")
        ->group("Input");
    volume.add_spacing_to(parser);
    volume.add_raw_to(parser);
    // A rank has one core, unless mpirun is told otherwise.
    run.threads = 1;
    run.add_to(parser);
    parser.get_option("--threads")
        ->description(
            "Threads of each rank; 0: as many as the machine has. The result\n"
            "does not depend on it (default 1)");
    parser.footer(parts_footer() + std::string("\n") + cleft_cli::exit_code_help());
}

void PartsArguments::add_sharing_to(CLI::App& parser)
{
    parser
        .add_option(
            "--scratch", scratch,
            "Folder for files without names, where a rank keeps the slabs of --block that it\ndoes not work on: "
            "it holds two at a time then")
        ->type_name("FOLDER");
    parser
        .add_option("--memory", memory,
                    "The most memory that a rank may take, such as 4G; one that needs more\n"
                    "ends the run. Without --scratch, files without names lie beside OUTPUT.\n"
                    "Without --block, slabs are as thick as the memory allows")
        ->type_name("SIZE");
    parser.add_flag("--ghosts", ghosts,
                    "Pieces of .pvtu also have the tetrahedra of others at their own\npoints, marked as ghosts");
}

bool PartsArguments::is_hdf5() const
{
    return volume.dims.empty() && (!dataset.empty() || has_extension_of(input(), kHdf5Extensions));
}

std::string PartsArguments::scratch_folder() const
{
    if (!scratch.empty() || memory.empty())
        return scratch;
    return cleft_cli::folder_of(outputs.front()).string();
}

std::string PartsArguments::target_of(const std::string& output)
{
    const std::filesystem::path target = cleft_cli::link_target(output);
    return target.extension() == std::filesystem::path(output).extension() ? target.string() : output;
}

std::vector<std::string> PartsArguments::pieces_of(const std::string& output, int ranks)
{
    std::vector<std::string> pieces;
    const std::filesystem::path path = target_of(output);
    for (int r = 0; r < ranks; ++r) {
        if (has_extension_of(output, {".pvtu"}))
            pieces.push_back((path.parent_path() / cleft::mpi::name_of_vtu_piece(path, r)).string());
        if (has_extension_of(output, {".mfem"}))
            pieces.push_back((path.parent_path() / cleft::mpi::name_of_mfem_part(path, r)).string());
    }
    return pieces;
}

void PartsArguments::check_outputs(int ranks) const
{
    cleft_cli::refuse_conflicts(volume.inputs, outputs, run.json,
                                [&](const std::string& output) { return pieces_of(output, ranks); });
    cleft_cli::check_json_output(run.json);
    for (const std::string& path : outputs) {
        if (!has_extension_of(path, kPartsExtensions))
            throw cleft_cli::usage_failure("--output: '" + path + "' ends with none of .vtkhdf .hdf .pvtu .mfem");
        cleft_cli::check_place(path);
        for (const std::string& piece : pieces_of(path, ranks))
            cleft_cli::check_place_beside(piece);
    }
}

}  // namespace cleft_mpi_cli
