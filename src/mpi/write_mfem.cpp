// MFEM's parallel meshes (MFEM mesh v1.2): a text for each rank, with what it shares with others. Written by MFEM's
// reader (ParMesh::Load() and GroupTopology::Load()): all ranks of a group list the same things in the same order, and
// corners of shared edges and triangles in the same order, too.
#include "io/atomic_file.hpp"
#include "io/group_numbers.hpp"
#include "io/label_names.hpp"
#include "mpi/part_writers.hpp"
#include "mpi/piece_names.hpp"
#include "mpi/shared_entities.hpp"

#include <algorithm>
#include <tuple>

namespace cleft::mpi
{

namespace
{

// Geometry::Type of MFEM.
constexpr int kTriangleOfMfem = 2, kTetOfMfem = 4;

// What a triangle bounds; interfaces come before the hull.
struct Bounded {
    int32_t side, first, second;
    bool operator<(const Bounded& o) const
    {
        return std::tie(side, first, second) < std::tie(o.side, o.first, o.second);
    }
    bool operator==(const Bounded& o) const { return !(*this < o) && !(o < *this); }
};

Bounded bounded_by(const PartView& part, int64_t triangle)
{
    return {part.sides[triangle], part.triangle_labels[2 * triangle], part.triangle_labels[2 * triangle + 1]};
}

// Those of all ranks, each once, ascending.
template <class T>
Array<T> all_of(std::vector<T> own, Exchange& exchange)
{
    const auto sort_once = [](auto& items) {
        std::sort(items.begin(), items.end());
        items.erase(std::unique(items.begin(), items.end()), items.end());
    };
    sort_once(own);
    Array<T> mine;
    mine.assign(own.begin(), own.end());
    Array<T> all = exchange.all_gather(mine);
    sort_once(all);
    return all;
}

// The numbers of labels and of what triangles bound, as in all formats that have both.
class Attributes
{
public:
    Attributes(const PartView& part, Exchange& exchange)
    {
        const Array<int32_t> labels =
            all_of(std::vector<int32_t>(part.labels, part.labels + part.counts.owned_tets), exchange);
        view_.labels.assign(labels.begin(), labels.end());
        std::vector<Bounded> own;
        for (int64_t t = 0; t < part.counts.triangles; ++t)
            own.push_back(bounded_by(part, t));
        bounded_ = all_of(own, exchange);
        for (const Bounded& b : bounded_)
            view_.groups.push_back(
                {io::surface_name(b.side, b.first, b.second), b.side, b.first, b.second, nullptr, 0, 0});
        io::number_groups(view_);
    }

    int32_t of_label(int32_t label) const
    {
        const auto found = std::lower_bound(view_.labels.begin(), view_.labels.end(), label);
        return view_.volume_numbers[to_size(found - view_.labels.begin())];
    }
    int32_t of_triangle(const Bounded& bounded) const
    {
        const auto found = std::lower_bound(bounded_.begin(), bounded_.end(), bounded);
        return view_.groups[to_size(found - bounded_.begin())].number;
    }
    void print_names(io::AtomicFile& file) const
    {
        for (size_t i = 0; i < view_.labels.size(); ++i)
            file.print("# ", view_.volume_numbers[i], " = ", io::material_name(view_.labels[i]), "\n");
        for (const io::SurfaceGroup& group : view_.groups)
            file.print("# ", group.number, " = ", group.name, "\n");
    }

private:
    io::MeshView view_;
    Array<Bounded> bounded_;
};

// The points of owned tetrahedra, counted from 0.
class Vertices
{
public:
    explicit Vertices(const PartView& part) : numbers_(to_size(part.counts.points), -1)
    {
        for (int64_t i = 0; i < 4 * part.counts.owned_tets; ++i)
            numbers_[to_size(part.tets[i])] = 0;
        for (size_t p = 0; p < numbers_.size(); ++p)
            if (numbers_[p] == 0) {
                numbers_[p] = static_cast<int32_t>(points_.size());
                points_.push_back(static_cast<int32_t>(p));
            }
    }
    int32_t number(int32_t point) const { return numbers_[to_size(point)]; }
    // As the part numbers them.
    const std::vector<int32_t>& points() const { return points_; }

    template <class Corners>
    void print(const Corners& corners, io::AtomicFile& file) const
    {
        const char* blank = "";
        for (const int32_t point : corners) {
            file.print(blank, number(point));
            blank = " ";
        }
        file.print("\n");
    }

private:
    std::vector<int32_t> numbers_, points_;
};

void print_mesh(const PartView& part, const Vertices& vertices, const Attributes& attributes, io::AtomicFile& file)
{
    file.print("\ndimension\n3\n\nelements\n", part.counts.owned_tets, "\n");
    for (int64_t t = 0; t < part.counts.owned_tets; ++t) {
        file.print(attributes.of_label(part.labels[t]), " ", kTetOfMfem, " ");
        const int32_t* c = part.tets + 4 * t;
        vertices.print(std::array<int32_t, 4>{c[0], c[1], c[2], c[3]}, file);
    }
    file.print("\nboundary\n", part.counts.triangles, "\n");
    for (int64_t t = 0; t < part.counts.triangles; ++t) {
        file.print(attributes.of_triangle(bounded_by(part, t)), " ", kTriangleOfMfem, " ");
        const int32_t* c = part.triangles + 3 * t;
        vertices.print(std::array<int32_t, 3>{c[0], c[1], c[2]}, file);
    }
    file.print("\nvertices\n", vertices.points().size(), "\n3\n");
    for (const int32_t point : vertices.points()) {
        const double* x = part.points + 3 * int64_t{point};
        file.print(x[0], " ", x[1], " ", x[2], "\n");
    }
}

using Groups = std::map<std::vector<int32_t>, SharedEntities>;

// Group 0 is the rank itself.
void print_groups(const Groups& groups, int32_t rank, io::AtomicFile& file)
{
    file.print("\ncommunication_groups\nnumber_of_groups ", groups.size() + 1,
               "\n\n# number of entities in each group, followed by ranks in group\n1 ", rank, "\n");
    size_t points = 0, edges = 0, triangles = 0;
    for (const auto& [ranks, shared] : groups) {
        file.print(ranks.size());
        for (const int32_t r : ranks)
            file.print(" ", r);
        file.print("\n");
        points += shared.points.size();
        edges += shared.edges.size();
        triangles += shared.triangles.size();
    }
    file.print("\ntotal_shared_vertices ", points, "\ntotal_shared_edges ", edges, "\ntotal_shared_faces ", triangles,
               "\n\n# group 0 has no shared entities\n");
}

void print_shared(const Groups& groups, const Vertices& vertices, io::AtomicFile& file)
{
    int group = 0;
    for (const auto& [ranks, shared] : groups) {
        file.print("\n# group ", ++group, "\nshared_vertices ", shared.points.size(), "\n");
        for (const auto& point : shared.points)
            vertices.print(point, file);
        file.print("\nshared_edges ", shared.edges.size(), "\n");
        for (const auto& edge : shared.edges)
            vertices.print(edge, file);
        file.print("\nshared_faces ", shared.triangles.size(), "\n");
        for (const auto& triangle : shared.triangles) {
            file.print(kTriangleOfMfem, " ");
            vertices.print(triangle, file);
        }
    }
}

}  // namespace

std::vector<std::string> write_mfem(const PartView& part, const Writing& writing)
{
    std::vector<std::string> names;
    for (int32_t r = 0; r < writing.exchange.ranks(); ++r)
        names.push_back(name_of_mfem_part(writing.stage.name(), r));
    writing.report(0);
    const Groups groups = shared_entities(part, writing.exchange);
    const Attributes attributes(part, writing.exchange);
    const Vertices vertices(part);
    writing.report(0.5);
    io::AtomicFile file(writing.stage.place(names[to_size(writing.exchange.rank())]));
    file.print("MFEM mesh v1.2\n\n");
    attributes.print_names(file);
    print_mesh(part, vertices, attributes, file);
    file.print("\nmfem_serial_mesh_end\n");
    print_groups(groups, writing.exchange.rank(), file);
    print_shared(groups, vertices, file);
    file.print("\nmfem_mesh_end\n");
    file.commit();
    return names;
}

}  // namespace cleft::mpi
