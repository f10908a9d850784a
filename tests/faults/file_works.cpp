// The file component: each format that is written, and each that is read.
#include "faults/works.hpp"

#ifdef CLEFT_WITH_IO

#include "cleft/cleft_io_parts.h"
#include "faults/digest.hpp"

#include <algorithm>

namespace faults
{
namespace
{

namespace fs = std::filesystem;

Work reads_volume(const std::string& path, const std::string& name)
{
    return {"reads " + name, [path](Bench& bench) {
                cleft_volume* volume = nullptr;
                const char* paths[1] = {path.c_str()};
                cleft_status status = cleft_io_read_volume(bench.context, bench.options, paths, 1, nullptr, &volume);
                int64_t counts[8] = {};
                const int64_t labels = std::min<int64_t>(8, cleft_volume_label_count(volume));
                if (status == CLEFT_OK)
                    status = cleft_volume_copy_voxel_counts(volume, counts, labels);
                if (status == CLEFT_OK)
                    bench.digest = digest(counts, 8);
                cleft_volume_destroy(volume);
                return status;
            }};
}

Work reads_raw(const std::string& path)
{
    return {"reads raw voxels", [path](Bench& bench) {
                cleft_volume* volume = nullptr;
                cleft_io_raw raw{};
                raw.struct_size = sizeof raw;
                raw.type = CLEFT_TYPE_UINT8;
                raw.dims[0] = 6, raw.dims[1] = 5, raw.dims[2] = 4;
                const char* paths[1] = {path.c_str()};
                cleft_status status = cleft_io_read_raw(bench.context, bench.options, paths, 1, &raw, &volume);
                int64_t counts[8] = {};
                if (status == CLEFT_OK)
                    status = cleft_volume_copy_voxel_counts(volume, counts, cleft_volume_label_count(volume));
                if (status == CLEFT_OK)
                    bench.digest = digest(counts, 8);
                cleft_volume_destroy(volume);
                return status;
            }};
}

Work reads_part(const std::string& path, const std::string& name)
{
    return {"reads a part of " + name, [path](Bench& bench) {
                cleft_voxels voxels{};
                voxels.struct_size = sizeof voxels;
                cleft_status status = cleft_io_voxels_open(bench.context, path.c_str(), nullptr, &voxels);
                if (status == CLEFT_OK) {
                    const int64_t first[3] = {1, 1, 1}, count[3] = {3, 2, 2};
                    int32_t labels[12] = {};
                    status = voxels.read(first, count, labels, nullptr, 0, voxels.user);
                    bench.digest = digest(labels, 12);
                }
                cleft_io_voxels_close(&voxels);
                return status;
            }};
}

Work reads_field(const std::string& path)
{
    return {"reads a field", [path](Bench& bench) {
                int64_t dims[3] = {};
                double* values = nullptr;
                const cleft_status status =
                    cleft_io_read_field(bench.context, path.c_str(), nullptr, dims, nullptr, &values);
                if (status == CLEFT_OK)
                    bench.digest = digest(values, dims[0] * dims[1] * dims[2]);
                cleft_io_free(values);
                return status;
            }};
}

Work reads_sizing(const std::string& path)
{
    return {"reads a sizing", [path](Bench& bench) {
                cleft_sizing* sizing = nullptr;
                const cleft_status status =
                    cleft_io_read_sizing(bench.context, bench.volume, path.c_str(), nullptr, 0, bench.options, &sizing);
                if (status == CLEFT_OK)
                    bench.digest = digest(cleft_sizing_values(sizing), 5 * 4 * 6);
                cleft_sizing_destroy(sizing);
                return status;
            }};
}

Work reads_mesh(const std::string& path, const std::string& name)
{
    return {"reads " + name, [path](Bench& bench) {
                cleft_mesh* mesh = nullptr;
                const cleft_status status = cleft_io_read_mesh(bench.context, path.c_str(), &mesh);
                if (status == CLEFT_OK)
                    bench.digest = digest_of(mesh);
                cleft_mesh_destroy(mesh);
                return status;
            }};
}

Work writes_mesh(const fs::path& folder, const std::string& name, cleft_io_format format,
                 std::vector<std::string> outputs)
{
    const std::string path = (folder / outputs.front()).string();
    return {
        "writes " + name,
        [path, format](Bench& bench) { return cleft_io_write_mesh(bench.context, bench.mesh, path.c_str(), format); },
        std::move(outputs)};
}

Work writes_sizing(const fs::path& folder, const std::string& name)
{
    const std::string path = (folder / name).string();
    return {"writes the sizing " + name,
            [path](Bench& bench) {
                return cleft_io_write_sizing(bench.context, bench.sizing, path.c_str(), CLEFT_IO_WORLD_LPS);
            },
            {name}};
}

Work writes_picture(const fs::path& folder)
{
    const std::string path = (folder / "a.png").string();
    return {"writes a picture",
            [path](Bench& bench) {
                cleft_io_picture picture{};
                picture.struct_size = sizeof picture;
                picture.width = picture.height = 64;
                picture.by = CLEFT_IO_BY_SIZE;
                picture.legend = 1;
                picture.cut[0] = 0.5;
                return cleft_io_write_picture(bench.context, bench.mesh, nullptr, 0, nullptr, 0, &picture,
                                              path.c_str());
            },
            {"a.png"}};
}

// Two meshes, of which a part is shown, so that the surface is made, too.
Work writes_view(const fs::path& folder)
{
    const std::string path = (folder / "a.html").string();
    return {"writes a view",
            [path](Bench& bench) {
                cleft_io_view view{};
                view.struct_size = sizeof view;
                view.max_tets = 50;
                view.title = "a";
                view.report = "{}";
                view.other = bench.mesh;
                return cleft_io_write_view(bench.context, bench.mesh, &view, path.c_str());
            },
            {"a.html"}};
}

}  // namespace

std::vector<Work> file_works(const fs::path& inputs, const fs::path& outputs)
{
    std::vector<Work> works;
    for (const char* name :
         {"raw.nrrd", "gzip.nrrd", "text.nrrd", "apart.nhdr", "voxels.mha", "apart.mhd", "points.vtk", "voxels.gipl",
          "voxels.gipl.gz", "voxels.mrc", "voxels.nii", "voxels.nii.gz", "pair.hdr", "stack.tif", "packed.tif",
          "slice%d.png", "slice*.bmp", "slice*.jpg", "series"})
        works.push_back(reads_volume((inputs / name).string(), name));
    // libtiff 4.5 does not test whether it got memory for a field of a header, and loses blocks of its codecs.
    for (Work& work : works)
        work.ours_alone = work.name == "reads stack.tif" || work.name == "reads packed.tif";
    works.push_back(reads_raw((inputs / "voxels.raw").string()));
    for (const char* name : {"raw.nrrd", "apart.nhdr", "voxels.mha", "points.vtk", "voxels.nii", "pair.hdr"})
        works.push_back(reads_part((inputs / name).string(), name));
    works.push_back(reads_field((inputs / "raw.nrrd").string()));

    const Bench bench(1);  // for the files that are read below
    for (const char* name : {"a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.vtk"})
        works.push_back(writes_sizing(outputs, name));
    works.push_back(writes_picture(outputs));
    works.push_back(writes_view(outputs));
    const std::string sizing = (inputs / "sizing.nrrd").string();
    if (cleft_io_write_sizing(bench.context, bench.sizing, sizing.c_str(), CLEFT_IO_WORLD_LPS) == CLEFT_OK)
        works.push_back(reads_sizing(sizing));

    for (int32_t row = 0; row < cleft_io_format_count(); ++row) {
        cleft_io_format_description format{};
        format.struct_size = sizeof format;
        if (cleft_io_format_info(row, &format) != CLEFT_OK || !(format.directions & CLEFT_IO_WRITES_MESH))
            continue;
        const std::string name = format.name, extensions = format.extensions;
        const std::string file = name + extensions.substr(0, extensions.find(' '));
        std::vector<std::string> files = {file};
        if (format.format == CLEFT_FORMAT_TETGEN)
            files = {"tetgen.node", "tetgen.ele", "tetgen.face"};
        works.push_back(writes_mesh(outputs, name, format.format, files));
        const std::string input = (inputs / file).string();
        if ((format.directions & CLEFT_IO_READS_MESH) &&
            cleft_io_write_mesh(bench.context, bench.mesh, input.c_str(), format.format) == CLEFT_OK)
            works.push_back(reads_mesh(input, name));
    }
    return works;
}

}  // namespace faults

#else

namespace faults
{

std::vector<Work> file_works(const std::filesystem::path&, const std::filesystem::path&) { return {}; }

}  // namespace faults

#endif
