// The arguments by which `mesh`, `sizing` and `info` read a volume, and the one place where they
// read it.
#include "volume_arguments.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cleft_cli
{
namespace
{

// The types of cleft_type under the names that NumPy uses.
const std::map<std::string, cleft_type> kVoxelTypes = {
    {"uint8", CLEFT_TYPE_UINT8},     {"uint16", CLEFT_TYPE_UINT16}, {"int16", CLEFT_TYPE_INT16},
    {"uint32", CLEFT_TYPE_UINT32},   {"int32", CLEFT_TYPE_INT32},   {"float32", CLEFT_TYPE_FLOAT32},
    {"float64", CLEFT_TYPE_FLOAT64},
};

std::vector<std::string> type_names()
{
    std::vector<std::string> names;
    for (const auto& [name, number] : kVoxelTypes)
        names.push_back(name);
    return names;
}

// CLI::PositiveNumber lets "nan" and "inf" through.
CLI::Validator positive_length()
{
    return {[](const std::string& text) {
                double value = 0;
                const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
                return good ? std::string() : "'" + text + "' is not a positive number";
            },
            ""};
}

// In the help.
constexpr const char* kGroup = "Input";

// What any volume means, and where its voxels are.
void add_grid_to(CLI::App& app, VolumeArguments& arguments)
{
    app.add_option("--world", arguments.world,
                   "Directions of the coordinates that come out: lps (ITK, DICOM, 3D\n"
                   "Slicer's files) or ras (NIfTI): x and y change their sign (default lps)")
        ->check(CLI::IsMember({"lps", "ras"}).description(""))
        ->type_name("lps|ras")
        ->group(kGroup);
    app.add_option("--as", arguments.kind,
                   "What the voxels mean: labels (rounded), or indicator functions, inside\n"
                   "where > 0. auto: what the values show; where they leave it open, the\n"
                   "file is refused (default auto)")
        ->check(CLI::IsMember({"auto", "labels", "indicators"}).description(""))
        ->type_name("auto|labels|indicators")
        ->group(kGroup);
    arguments.add_spacing_to(app);
    app.add_option("--scale", arguments.scale,
                   "Multiply origin and spacing of the file by S: 0.001 makes metres of\n"
                   "millimetres. A --spacing beside it is taken as it is")
        ->check(positive_length())
        ->type_name("S")
        ->group(kGroup);
}

}  // namespace

void VolumeArguments::add_inputs_to(CLI::App& app)
{
    app.add_option("INPUT", inputs,
                   "A label map (NRRD, NIfTI, MetaImage, TIFF stack, DICOM folder ...),\n"
                   "or several files: one mask or one indicator function a material, of\n"
                   "which the largest wins; materials are called 0, 1, 2, ... in the order\n"
                   "of the files")
        ->required()
        ->type_name("");
}

void VolumeArguments::add_reading_to(CLI::App& app)
{
    add_grid_to(app, *this);
    add_raw_to(app);
    // Raw voxels have no unit of a file that a scale could change.
    app.get_option("--dims")->excludes(app.get_option("--scale"));
}

void VolumeArguments::add_spacing_to(CLI::App& app)
{
    app.add_option("--spacing", spacing, "Size of a voxel, instead of the file's")
        ->expected(3)
        ->delimiter(',')
        ->check(positive_length())
        ->type_name("H")
        ->group(kGroup);
}

void VolumeArguments::add_raw_to(CLI::App& app)
{
    CLI::Option* raw =
        app.add_option("--dims", dims, "Read raw voxels without a header: voxels along x (fastest), y, z")
            ->expected(3)
            ->delimiter(',')
            ->check(CLI::PositiveNumber.description(""))
            ->type_name("N")
            ->group(kGroup);
    // A header tells these three. Without --dims they would have no effect, and the user would not know.
    app.add_option("--type", type,
                   "Type of raw voxels: uint8, uint16, int16, uint32, int32, float32,\nfloat64 (default uint8)")
        ->check(CLI::IsMember(type_names()).description(""))
        ->type_name("TYPE")
        ->needs(raw)
        ->group(kGroup);
    app.add_option("--skip", skip, "Bytes before the first raw voxel (default 0)")
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("BYTES")
        ->needs(raw)
        ->group(kGroup);
    app.add_flag("--big-endian", big_endian, "Raw voxels have their most significant byte first")
        ->needs(raw)
        ->group(kGroup);
}

cleft_io_raw VolumeArguments::raw() const
{
    cleft_io_raw out = {};
    out.struct_size = sizeof out;
    out.type = kVoxelTypes.at(type);
    out.big_endian = big_endian ? 1 : 0;
    out.kind = kind_number();
    out.skip = skip;
    std::copy(dims.begin(), dims.end(), out.dims);
    // CLI11 has checked that there are three numbers, or none.
    std::copy(spacing.begin(), spacing.end(), out.spacing);
    return out;
}

cleft_io_kind VolumeArguments::kind_number() const
{
    return kind == "labels"       ? CLEFT_IO_KIND_LABELS
           : kind == "indicators" ? CLEFT_IO_KIND_INDICATORS
                                  : CLEFT_IO_KIND_AUTO;
}

cleft_io_reading VolumeArguments::reading() const
{
    cleft_io_reading reading = {};
    reading.struct_size = sizeof reading;
    reading.world = world_number();
    reading.kind = kind_number();
    std::copy(spacing.begin(), spacing.end(), reading.spacing);
    reading.scale = scale;
    return reading;
}

Volume VolumeArguments::read(Session& session, const cleft_options* options) const
{
    std::vector<const char*> paths;
    for (const std::string& input : inputs)
        paths.push_back(input.c_str());
    const auto count = static_cast<int64_t>(paths.size());
    return session.make<Volume>(EXIT_CANNOT_READ, [&](cleft_volume** out) {
        // The dimensions make a file raw; nothing else tells it.
        if (dims.empty()) {
            const cleft_io_reading how = reading();
            return cleft_io_read_volume(session.context(), options, paths.data(), count, &how, out);
        }
        const cleft_io_raw layout = raw();
        return cleft_io_read_raw(session.context(), options, paths.data(), count, &layout, out);
    });
}

}  // namespace cleft_cli
