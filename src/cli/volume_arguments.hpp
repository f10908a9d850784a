// The arguments that say what to read: files, world, raw layout.
#pragma once

#include "session.hpp"

#include "cleft/cleft_io.h"

#include <string>
#include <vector>

namespace cleft_cli
{

struct VolumeArguments {
    std::vector<std::string> inputs;
    std::string world = "lps";
    std::string kind = "auto";
    std::vector<double> spacing;  // empty: the file's
    double scale = 0;             // 0: none
    std::vector<int64_t> dims;    // not empty: a raw file
    std::string type = "uint8";
    int64_t skip = 0;
    bool big_endian = false;

    void add_inputs_to(CLI::App& app);
    // The options without the files themselves.
    void add_reading_to(CLI::App& app);
    // Of these, what a header would tell of raw voxels, and the size of a voxel.
    void add_spacing_to(CLI::App& app);
    void add_raw_to(CLI::App& app);

    // For cleft_io_read_volume(): struct_size is set, and zeros stand for the defaults.
    cleft_io_reading reading() const;
    // For cleft_io_read_raw(), if `dims` is not empty.
    cleft_io_raw raw() const;
    cleft_io_kind kind_number() const;
    cleft_io_world world_number() const { return world == "ras" ? CLEFT_IO_WORLD_RAS : CLEFT_IO_WORLD_LPS; }
    // Throws Failure with EXIT_CANNOT_READ. `options` may be null.
    Volume read(Session& session, const cleft_options* options) const;
};

}  // namespace cleft_cli
