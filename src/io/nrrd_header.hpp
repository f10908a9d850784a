// The header of an NRRD file as it stands there.
#pragma once

#include "io/vector3.hpp"
#include "io/voxel_data.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cleft::io
{

struct NrrdHeader {
    std::vector<int64_t> sizes;
    Component component = Component::uint8;
    VoxelData data;  // files and skips too
    // What is said of each axis; empty, or as long as `sizes`.
    // No value: "none", an axis that is not of space.
    std::vector<std::optional<std::vector<double>>> directions;
    std::vector<double> spacings;
    std::vector<double> mins;
    std::vector<double> maxs;
    std::vector<std::string> centers;
    std::vector<std::string> kinds;
    // Of the space; empty and 0 if there is none.
    // In small letters, as written. Its name is judged by set_nrrd_geometry().
    std::string space;
    size_t space_dimension = 0;
    std::vector<double> origin;
    std::string measurement_frame;            // as written; see nrrd_measurement_frame()
    std::map<std::string, std::string> keys;  // key:=value
    std::vector<std::string> notes;
};

// "(1,0,0) none (0,0,2)": vectors, of which those of axes that have none are absent.
std::vector<std::optional<std::vector<double>>> nrrd_vectors(const std::string& field, std::string_view value);

// Throws Errors that do not name the file.
NrrdHeader read_nrrd_header(const std::string& path);

}  // namespace cleft::io
