// write_cases DIRECTORY: writes the meshes of mesh_cases() with what the library measures of each, for
// check_validator.py: NAME.mesh (MEDIT, materials as references) and NAME.json.
#include "checking/validate.hpp"
#include "support/meshes.hpp"

#include <cstdio>
#include <fstream>

using namespace cleft;
using namespace cleft_test;

namespace
{

std::ofstream create(const std::string& path)
{
    std::ofstream file(path);
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.precision(17);
    return file;
}

void write_mesh(const std::string& path, const LabelledMesh& mesh)
{
    std::ofstream file = create(path);
    file << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.points.size() << '\n';
    for (const Vec3& x : mesh.points)
        file << x[0] << ' ' << x[1] << ' ' << x[2] << " 0\n";
    file << "Tetrahedra\n" << mesh.tets.size() << '\n';
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const int32_t p : mesh.tets[t])
            file << p + 1 << ' ';
        file << mesh.material[t] << '\n';
    }
    file << "End\n";
}

void write_measures(const std::string& path, const LabelledMesh& mesh)
{
    const Run run;
    const Validation v = validate(mesh, true, run);
    const Quality q = measure_quality(mesh.points, mesh.tets, run);
    const Array<std::pair<const char*, double>> doubles = {
        {"volume", v.volume},
        {"box_volume", v.box_volume},
        {"hull_area", v.hull_area},
        {"box_area", v.box_area},
        {"min_dihedral", q.min_dihedral},
        {"max_dihedral", q.max_dihedral},
        {"radius_ratio_median", q.radius_ratio_median},
        {"radius_ratio_95", q.radius_ratio_95},
        {"min_edge", q.min_edge},
        {"mean_edge", q.mean_edge},
        {"max_edge", q.max_edge},
        {"min_volume", q.min_volume},
        {"total_volume", q.total_volume},
    };
    const Array<std::pair<const char*, int64_t>> counts = {
        {"tets", q.tets},
        {"repeated_corner", v.repeated_corner},
        {"negative", v.negative},
        {"flat", v.flat},
        {"hull_faces", v.hull_faces},
        {"shared_faces", v.shared_faces},
        {"crowded_faces", v.crowded_faces},
        {"folded_faces", v.folded_faces},
        {"hull_off_box", v.hull_off_box},
        {"interface_faces", v.interface_faces},
        {"open_interface_edges", v.open_interface_edges},
        {"unused_points", v.unused_points},
        {"repeated_points", v.repeated_points},
        {"below_5", q.below_5},
        {"below_10", q.below_10},
        {"below_15", q.below_15},
        {"below_20", q.below_20},
        {"above_165", q.above_165},
    };
    std::ofstream file = create(path);
    file << "{";
    for (const auto& [name, value] : doubles)
        file << '"' << name << "\": " << value << ",\n";
    for (const auto& [name, value] : counts)
        file << '"' << name << "\": " << value << ",\n";
    file << "\"valid\": " << (v.valid() ? "true" : "false") << "}\n";
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "write_cases DIRECTORY\n");
        return 2;
    }
    const std::string directory = argv[1];
    for (const MeshCase& c : mesh_cases()) {
        write_mesh(directory + "/" + c.name + ".mesh", c.mesh);
        write_measures(directory + "/" + c.name + ".json", c.mesh);
    }
    return 0;
}
