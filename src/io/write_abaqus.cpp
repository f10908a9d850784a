// Abaqus and CalculiX .inp: C3D4 elements in one ELSET for each label; SURFACE and NSET for each interface and each
// side of the box. It holds the mesh alone, to be taken into a job by *INCLUDE.
#include "base/error.hpp"
#include "io/ascii.hpp"
#include "io/atomic_file.hpp"
#include "io/element_faces.hpp"
#include "io/label_names.hpp"
#include "io/writers.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

// A surface of the file: several groups of triangles make one side of the box.
struct Set {
    std::string name;
    std::vector<size_t> groups;
};

std::vector<Set> collect_sets(const MeshView& mesh)
{
    // In the order of CLEFT_SIDE_X_MIN to CLEFT_SIDE_OTHER. Loads and supports are applied to a
    // whole side, so its labels are put together.
    static const char* const sides[] = {"BOX_X_MIN", "BOX_X_MAX", "BOX_Y_MIN", "BOX_Y_MAX",
                                        "BOX_Z_MIN", "BOX_Z_MAX", "HULL"};
    std::vector<Set> sets;
    for (size_t g = 0; g < mesh.groups.size(); ++g) {
        const SurfaceGroup& group = mesh.groups[g];
        // Abaqus and CalculiX turn names into capitals. In the file they look as the solver reports them.
        const std::string name = group.is_interface() ? in_capitals(group.name) : sides[group.side];
        // Groups of one side follow each other, as the hull is sorted by sides.
        if (sets.empty() || sets.back().name != name)
            sets.push_back({name, {}});
        sets.back().groups.push_back(g);
    }
    return sets;
}

void write_node_set(const MeshView& mesh, const Set& set, std::vector<int32_t>& scratch, AtomicFile& file)
{
    scratch.clear();
    for (const size_t g : set.groups)
        scratch.insert(scratch.end(), mesh.groups[g].triangles, mesh.groups[g].triangles + 3 * mesh.groups[g].count);
    std::sort(scratch.begin(), scratch.end());
    // A point lies at about six triangles, so the file would name it six times.
    scratch.erase(std::unique(scratch.begin(), scratch.end()), scratch.end());
    // *NSET takes at most 16 entries a line.
    constexpr size_t kPerLine = 16;
    file.print("*NSET, NSET=", set.name, '\n');
    for (size_t i = 0; i < scratch.size(); ++i) {
        const bool ends = i + 1 == scratch.size() || i % kPerLine == kPerLine - 1;
        file.print(scratch[i] + int64_t{1}, ends ? '\n' : ',');
    }
}

void write_surface(const MeshView& mesh, const Set& set, const std::vector<std::vector<ElementFace>>& faces,
                   AtomicFile& file)
{
    file.print("*SURFACE, NAME=", set.name, ", TYPE=ELEMENT\n");
    for (const size_t g : set.groups)
        for (int64_t t = 0; t < mesh.groups[g].count; ++t) {
            const ElementFace& face = faces[g][static_cast<size_t>(t)];
            file.print(face.tet + 1, ", S", face.face + 1, '\n');
        }
}

void write_elements(const MeshView& mesh, AtomicFile& file)
{
    // An *ELEMENT block names one set, so elements are gathered by label. Their numbers stay those
    // of the mesh.
    std::vector<std::vector<int64_t>> tets(mesh.labels.size());
    for (int64_t t = 0; t < mesh.tet_count; ++t)
        tets[mesh.label_index(mesh.tet_labels[t])].push_back(t);
    for (size_t m = 0; m < tets.size(); ++m) {
        const std::string set = in_capitals(material_name(mesh.labels[m]));
        file.print("*ELEMENT, TYPE=C3D4, ELSET=", set, '\n');
        for (const int64_t t : tets[m]) {
            const int32_t* c = mesh.tets + 4 * t;
            file.print(t + 1, ',', c[0] + int64_t{1}, ',', c[1] + int64_t{1}, ',', c[2] + int64_t{1}, ',',
                       c[3] + int64_t{1}, '\n');
        }
        // A second set with the name of the label. Scripts find the first one by the label alone.
        const std::string named = in_capitals(mesh.material(m));
        if (named != set)
            file.print("*ELSET, ELSET=", named, '\n', set, '\n');
    }
}

}  // namespace

void write_abaqus(const MeshView& mesh, const std::string& path)
{
    // Before the file is opened, as it may throw.
    const std::vector<std::vector<ElementFace>> faces = find_element_faces(mesh);
    AtomicFile file(path);
    file.print(
        "** Tetrahedra by cleft: ELSET MATERIAL_<label>; SURFACE and NSET INTERFACE_<label>_<label>, BOX_<side>.\n"
        "** The faces of an interface are those of the elements of its first label.\n*NODE, NSET=ALL\n");
    for (int64_t i = 0; i < mesh.point_count; ++i) {
        const double* p = mesh.points + 3 * i;
        file.print(i + 1, ',', p[0], ',', p[1], ',', p[2], '\n');
    }
    write_elements(mesh, file);
    std::vector<int32_t> scratch;
    for (const Set& set : collect_sets(mesh)) {
        write_node_set(mesh, set, scratch, file);
        write_surface(mesh, set, faces, file);
    }
    file.commit();
}

}  // namespace cleft::io
