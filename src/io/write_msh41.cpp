// Gmsh 4.1, binary: one discrete surface for each group of triangles, one discrete volume for each label, each with a
// physical group of its own number.
#include "io/gmsh_model.hpp"
#include "io/inner_surface.hpp"
#include "io/writers.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace cleft::io
{

namespace
{

struct Box {
    std::array<double, 6> bounds;  // least x y z, greatest x y z

    // An empty box: the first point sets both ends.
    Box()
    {
        std::fill_n(bounds.begin(), 3, std::numeric_limits<double>::max());
        std::fill_n(bounds.begin() + 3, 3, std::numeric_limits<double>::lowest());
    }
    void add(const double* point)
    {
        for (size_t axis = 0; axis < 3; ++axis) {
            bounds[axis] = std::min(bounds[axis], point[axis]);
            bounds[axis + 3] = std::max(bounds[axis + 3], point[axis]);
        }
    }
};

// The mesh in the order of its entities: surfaces first, then volumes.
struct Entities {
    std::vector<std::vector<int64_t>> tets;        // of each volume
    std::vector<std::vector<int32_t>> points;      // of each surface, then of each volume
    std::vector<Box> boxes;                        // of each surface, then of each volume
    std::vector<std::vector<int32_t>> boundaries;  // signed numbers of the surfaces around each volume
};

// A point is stored with one entity. Surfaces come first, so that points at interfaces belong to
// the surface, as Gmsh has it.
void collect_surfaces(const MeshView& mesh, std::vector<bool>& taken, Entities& entities)
{
    for (size_t g = 0; g < mesh.groups.size(); ++g) {
        const SurfaceGroup& group = mesh.groups[g];
        for (int64_t c = 0; c < 3 * group.count; ++c) {
            const int32_t p = group.triangles[c];
            entities.boxes[g].add(mesh.points + 3 * int64_t{p});
            if (!taken[static_cast<size_t>(p)])
                entities.points[g].push_back(p);
            taken[static_cast<size_t>(p)] = true;
        }
        // Normals point out of the first volume and into the second.
        entities.boundaries[mesh.label_index(group.first)].push_back(group.number);
        if (group.is_interface())
            entities.boundaries[mesh.label_index(group.second)].push_back(-group.number);
    }
}

void collect_volumes(const MeshView& mesh, std::vector<bool>& taken, Entities& entities)
{
    const size_t surfaces = mesh.groups.size();
    for (int64_t t = 0; t < mesh.tet_count; ++t) {
        const size_t volume = mesh.label_index(mesh.tet_labels[t]);
        entities.tets[volume].push_back(t);
        for (int corner = 0; corner < 4; ++corner) {
            const int32_t p = mesh.tets[4 * t + corner];
            entities.boxes[surfaces + volume].add(mesh.points + 3 * int64_t{p});
            if (!taken[static_cast<size_t>(p)])
                entities.points[surfaces + volume].push_back(p);
            taken[static_cast<size_t>(p)] = true;
        }
    }
    for (int32_t p = 0; p < mesh.point_count && !mesh.labels.empty(); ++p)
        if (!taken[static_cast<size_t>(p)])
            entities.points.back().push_back(p);  // in no tetrahedron, but every point must belong somewhere
}

// Each point belongs to the first entity that has it.
Entities collect_entities(const MeshView& mesh)
{
    Entities entities;
    entities.tets.resize(mesh.labels.size());
    entities.boundaries.resize(mesh.labels.size());
    entities.points.resize(mesh.groups.size() + mesh.labels.size());
    entities.boxes.resize(entities.points.size());
    std::vector<bool> taken(static_cast<size_t>(mesh.point_count), false);
    collect_surfaces(mesh, taken, entities);
    collect_volumes(mesh, taken, entities);
    // Ascending numbers within each entity make the file independent of the order of elements.
    for (std::vector<int32_t>& points : entities.points)
        std::sort(points.begin(), points.end());
    return entities;
}

// Of entity e: surfaces come first.
int32_t entity_number(const MeshView& mesh, size_t e)
{
    const size_t surfaces = mesh.groups.size();
    return e < surfaces ? mesh.groups[e].number : mesh.volume_numbers[e - surfaces];
}

void write_entities(const MeshView& mesh, const Entities& entities, AtomicFile& file)
{
    const size_t surfaces = mesh.groups.size();
    file.print("$Entities\n");
    // MSH 4.1, $Entities: numbers of points, curves, surfaces and volumes. Discrete surfaces need
    // no curves.
    for (const size_t count : {size_t{0}, size_t{0}, surfaces, mesh.labels.size()})
        file.binary(count);
    for (size_t e = 0; e < entities.points.size(); ++e) {
        const bool is_surface = e < surfaces;
        const int32_t number = entity_number(mesh, e);
        file.binary(number);
        file.binary(entities.boxes[e].bounds);
        // One physical group, of the same number as the entity.
        file.binary(size_t{1});
        file.binary(number);
        const std::vector<int32_t> boundary = is_surface ? std::vector<int32_t>() : entities.boundaries[e - surfaces];
        file.binary(boundary.size());
        file.write(boundary.data(), boundary.size() * sizeof(int32_t));
    }
    file.print("\n$EndEntities\n");
}

void write_nodes(const MeshView& mesh, const Entities& entities, AtomicFile& file)
{
    const size_t surfaces = mesh.groups.size();
    const size_t points = static_cast<size_t>(mesh.point_count);
    file.print("$Nodes\n");
    // MSH 4.1, $Nodes: number of entity blocks, number of nodes, least and greatest tag.
    for (const size_t number : {entities.points.size(), points, std::min(points, size_t{1}), points})
        file.binary(number);
    for (size_t e = 0; e < entities.points.size(); ++e) {
        file.binary(int32_t{e < surfaces ? 2 : 3});
        file.binary(entity_number(mesh, e));
        // Not parametric.
        file.binary(int32_t{0});
        file.binary(entities.points[e].size());
        for (const int32_t p : entities.points[e])
            file.binary(static_cast<size_t>(p) + 1);
        for (const int32_t p : entities.points[e])
            file.write(mesh.points + 3 * int64_t{p}, 3 * sizeof(double));
    }
    file.print("\n$EndNodes\n");
}

void write_element(AtomicFile& file, size_t number, const int32_t* corners, size_t count)
{
    std::array<size_t, 5> row{number};
    for (size_t c = 0; c < count; ++c)
        row[c + 1] = static_cast<size_t>(corners[c]) + 1;
    file.write(row.data(), (count + 1) * sizeof(size_t));
}

void write_elements(const MeshView& mesh, const Entities& entities, AtomicFile& file)
{
    const size_t total = static_cast<size_t>(mesh.triangle_count() + mesh.tet_count);
    file.print("$Elements\n");
    // MSH 4.1, $Elements: number of entity blocks, number of elements, least and greatest tag.
    for (const size_t number : {entities.points.size(), total, std::min(total, size_t{1}), total})
        file.binary(number);
    size_t element = 0;
    for (const SurfaceGroup& group : mesh.groups) {
        file.binary(std::array<int32_t, 3>{2, group.number, kGmshTriangle});
        file.binary(static_cast<size_t>(group.count));
        for (int64_t t = 0; t < group.count; ++t)
            write_element(file, ++element, group.triangles + 3 * t, 3);
    }
    for (size_t v = 0; v < entities.tets.size(); ++v) {
        file.binary(std::array<int32_t, 3>{3, mesh.volume_numbers[v], kGmshTetrahedron});
        file.binary(entities.tets[v].size());
        for (const int64_t t : entities.tets[v])
            write_element(file, ++element, mesh.tets + 4 * t, 4);
    }
    file.print("\n$EndElements\n");
}

}  // namespace

void write_msh41(const MeshView& mesh, const std::string& path)
{
    static_assert(sizeof(size_t) == 8, "the format says how large size_t is");
    const Entities entities = collect_entities(mesh);
    AtomicFile file(path);
    file.print("$MeshFormat\n4.1 1 8\n");
    // The number 1, by which a reader finds out the order of bytes.
    file.binary(int32_t{1});
    file.print("\n$EndMeshFormat\n");
    write_physical_names(mesh, file);
    write_entities(mesh, entities, file);
    write_nodes(mesh, entities, file);
    write_elements(mesh, entities, file);
    file.commit();
}

}  // namespace cleft::io
