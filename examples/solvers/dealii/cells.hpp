/* The tetrahedra that a rank of deal.II must know: its own, and all of others that have a point in common with them. */
#ifndef CELLS_HPP
#define CELLS_HPP

#include <cleft/cleft_mpi.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

/* A tetrahedron as ranks send it: numbers are those in the whole mesh. */
struct Cell {
    std::int64_t number;
    std::int64_t points[4];
    double places[4][3];
    std::int32_t label;
    std::int32_t rank;

    template <class Archive>
    void serialize(Archive& archive, unsigned int)
    {
        archive& number& points& places& label& rank;
    }
};

/* A rank that has tetrahedra at a point. */
using PointAndRank = std::pair<std::int64_t, unsigned int>;

inline Cell cell_of(const cleft_part* part, std::int64_t tet)
{
    Cell cell{
        cleft_part_tet_numbers(part)[tet], {}, {}, cleft_part_tet_labels(part)[tet], cleft_part_tet_owners(part)[tet]};
    for (int c = 0; c < 4; ++c) {
        const std::int32_t point = cleft_part_tets(part)[4 * tet + c];
        cell.points[c] = cleft_part_point_numbers(part)[point];
        std::copy_n(cleft_part_points(part) + 3 * point, 3, cell.places[c]);
    }
    return cell;
}

/* Tells each rank which of its points others have tetrahedra at. The owner of a point knows that, since its part has
 * all tetrahedra there: its own ones and ghosts. */
inline std::map<unsigned int, std::vector<PointAndRank>> meeting_ranks(const cleft_part* part,
                                                                       const cleft_part_counts& n)
{
    std::map<std::int32_t, std::set<unsigned int>> ranks_at;
    for (std::int64_t t = 0; t < n.tets; ++t)
        for (int c = 0; c < 4; ++c)
            if (const std::int32_t point = cleft_part_tets(part)[4 * t + c]; point < n.owned_points)
                ranks_at[point].insert(cleft_part_tet_owners(part)[t]);
    std::map<unsigned int, std::vector<PointAndRank>> out;
    for (const auto& [point, ranks] : ranks_at)
        for (const unsigned int to : ranks)
            for (const unsigned int other : ranks)
                if (to != other)
                    out[to].emplace_back(n.first_point + point, other);
    return out;
}

/* The rank's own tetrahedra, then those of others. The part has ghosts. */
inline std::vector<Cell> relevant_cells(MPI_Comm comm, const cleft_part* part)
{
    cleft_part_counts n{};
    n.struct_size = sizeof n;
    if (cleft_part_count(part, &n) != CLEFT_OK)
        return {};
    std::unordered_map<std::int64_t, std::set<unsigned int>> others_at;
    for (const auto& [from, pairs] : dealii::Utilities::MPI::some_to_some(comm, meeting_ranks(part, n)))
        for (const auto& [point, other] : pairs)
            others_at[point].insert(other);

    std::vector<Cell> cells;
    std::map<unsigned int, std::vector<Cell>> sent;
    for (std::int64_t t = 0; t < n.owned_tets; ++t) {
        cells.push_back(cell_of(part, t));
        std::set<unsigned int> receivers;
        for (const std::int64_t point : cells.back().points)
            if (const auto found = others_at.find(point); found != others_at.end())
                receivers.insert(found->second.begin(), found->second.end());
        for (const unsigned int to : receivers)
            sent[to].push_back(cells.back());
    }
    for (const auto& [from, received] : dealii::Utilities::MPI::some_to_some(comm, sent))
        cells.insert(cells.end(), received.begin(), received.end());
    return cells;
}

#endif
