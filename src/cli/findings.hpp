// What is found out about a mesh, for the summary and the machine-readable report.
#pragma once

#include "session.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cleft_cli
{

struct LabelTotals {
    int64_t tets = 0;
    double volume = 0;
};

struct MeshFindings {
    int64_t points = 0;
    int64_t tets = 0;
    std::optional<int64_t> interface_triangles;  // none if the mesh is too broken to have interfaces
    std::optional<int64_t> hull_triangles;
    std::array<double, 3> low{}, high{};  // bounding box
    std::map<int32_t, LabelTotals> labels;
    std::map<int32_t, std::string> names;  // of each label, "" if it has none
    cleft_quality quality{};

    // Counts them, and finds their box, or their labels and volumes.
    void take_points(const double* coordinates, int64_t count);
    void take_tets(const double* coordinates, const int32_t* corners, const int32_t* tet_labels, int64_t count);
};

// Throws Failure. Volumes are in the cube of the mesh's unit.
MeshFindings look_at_mesh(const Session& session, const cleft_mesh* mesh);

struct VolumeFindings {
    std::array<int64_t, 3> dims{};
    std::array<double, 12> affine{};
    std::array<double, 3> spacing{};
    std::map<int32_t, int64_t> voxels;     // of each label
    std::map<int32_t, std::string> names;  // of each label, "" if it has none

    int64_t voxel_count() const { return dims[0] * dims[1] * dims[2]; }
    // From the affine map.
    void take_spacing();
    // The determinant of the affine map, without its sign.
    double voxel_volume() const;
    // The corners of the box in world coordinates, least and greatest.
    void bounds(std::array<double, 3>& low, std::array<double, 3>& high) const;
};

// Throws Failure where the library does.
VolumeFindings look_at_volume(const Session& session, const cleft_volume* volume);

// The library's per-label report as values.
// struct_size must be that of the base: see look_at_labels().
struct LabelFindings : cleft_label_report {
    std::string name;  // "" if it has none
};
struct ReportFindings {
    std::vector<LabelFindings> labels;
    std::vector<cleft_contact> contacts;    // that the voxels do not have
    std::vector<cleft_distance> distances;  // if they were asked for
};
// Compares the mesh with the volume that it was made of, label by label; with distances, also interface by interface.
ReportFindings look_at_labels(const Session& session, const cleft_volume* volume, const cleft_mesh* mesh,
                              bool with_distances);
// How much more volume the label has in the mesh than in the voxels, in percent of the latter.
double difference_percent(const cleft_label_report& row);

}  // namespace cleft_cli
