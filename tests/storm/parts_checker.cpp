// What a rank owns is looked for in the whole mesh under the same numbers. One rank may cancel or fail to read; then
// all ranks must say so.
#include "storm/parts_checker.hpp"

#include "parts/ranks.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <regex>

namespace storm
{

namespace
{

using PartPointer = std::unique_ptr<cleft_part, decltype(&cleft_part_destroy)>;

// A rank: what it is given, and what it gets.
struct Rank {
    const Case* drawn = nullptr;
    const cleft_options* options = nullptr;
    bool is_upset = false;  // it is the one that cancels or fails to read
    int64_t reports = 0, reads = 0;
    bool has_cancelled = false, has_failed = false;
    cleft_status status = CLEFT_OK;
    std::string sentence;
    PartPointer part{nullptr, cleft_part_destroy};
};

int read_box(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room, void* user)
{
    Rank& rank = *static_cast<Rank*>(user);
    const Case& drawn = *rank.drawn;
    if (rank.is_upset && ++rank.reads == drawn.fail_at) {
        rank.has_failed = true;
        std::snprintf(sentence, static_cast<size_t>(room), "the tape is worn");
        return 1;
    }
    auto* out = static_cast<int32_t*>(voxels);
    for (int64_t k = first[2]; k < first[2] + count[2]; ++k)
        for (int64_t j = first[1]; j < first[1] + count[1]; ++j)
            out = std::copy_n(drawn.labels.data() + first[0] + drawn.dims[0] * (j + drawn.dims[1] * k), count[0], out);
    return 0;
}

int cancel_in_time(double, const char*, void* user)
{
    Rank& rank = *static_cast<Rank*>(user);
    if (!rank.is_upset || ++rank.reports != rank.drawn->cancel_at)
        return 0;
    rank.has_cancelled = true;
    return 1;
}

void make_part(const cleft_exchange* exchange, void* user)
{
    Rank& rank = *static_cast<Rank*>(user);
    const Case& drawn = *rank.drawn;
    cleft_voxels voxels = {sizeof voxels, drawn.type, {0, 0, 0}, {0}, user, read_box};
    std::copy(drawn.dims.begin(), drawn.dims.end(), voxels.dims);
    std::copy(drawn.affine.begin(), drawn.affine.end(), voxels.affine);
    cleft_context* context = nullptr;
    if (cleft_context_create(&context) != CLEFT_OK || cleft_context_set_threads(context, drawn.threads) != CLEFT_OK ||
        cleft_context_set_progress(context, cancel_in_time, user) != CLEFT_OK)
        std::abort();
    cleft_exchange with_scratch = *exchange;
    if (drawn.has_scratch)
        with_scratch.scratch = ".";
    cleft_part* part = nullptr;
    rank.status = cleft_part_create(context, &voxels, rank.options, &with_scratch, drawn.has_ghosts, &part);
    rank.part.reset(part);
    rank.sentence = cleft_context_last_error(context);
    cleft_context_destroy(context);
}

class PartsChecker
{
public:
    PartsChecker(const std::vector<Rank>& ranks, const WholeMesh& whole) : ranks_(ranks), whole_(whole) {}

    std::string fault() const
    {
        const std::string fault = fault_of_statuses();
        return fault.empty() && ranks_.front().status == CLEFT_OK ? fault_of_pieces() : fault;
    }

private:
    static std::string of_rank(size_t rank, const std::string& words)
    {
        return "rank " + std::to_string(rank) + " " + words;
    }

    // A rank that failed says so to all; a cancel can come too late.
    bool is_right(cleft_status status) const
    {
        const auto any = [&](bool Rank::*what) {
            return std::any_of(ranks_.begin(), ranks_.end(), [&](const Rank& rank) { return rank.*what; });
        };
        if (any(&Rank::has_failed))
            return status == CLEFT_ERROR_FILE;
        return status == whole_.status || (status == CLEFT_ERROR_CANCELLED && any(&Rank::has_cancelled));
    }

    std::string fault_of_statuses() const
    {
        for (size_t r = 0; r < ranks_.size(); ++r) {
            const Rank& rank = ranks_[r];
            const std::string words = std::to_string(rank.status) + " (" + rank.sentence + ")";
            if (!is_right(rank.status))
                return of_rank(r, "has status " + words + ", but the whole mesh " + std::to_string(whole_.status) +
                                      " (" + whole_.sentence + ")");
            if (rank.status != ranks_.front().status || rank.sentence != ranks_.front().sentence)
                return of_rank(r, "has status " + words + ", but rank 0 " + std::to_string(ranks_.front().status) +
                                      " (" + ranks_.front().sentence + ")");
            if ((rank.status == CLEFT_OK) != (rank.part != nullptr))
                return of_rank(r, "has status " + words + ", and a part or none that does not go with it");
            if (rank.status != CLEFT_OK && rank.status == whole_.status &&
                !ends_with(without_ordinals(rank.sentence), without_ordinals(whole_.sentence)))
                return of_rank(r, "says: " + rank.sentence + "; but the whole mesh: " + whole_.sentence);
        }
        return "";
    }

    // A rank counts points and tetrahedra in its part.
    static std::string without_ordinals(const std::string& sentence)
    {
        static const std::regex ordinal("[0-9]+(st|nd|rd|th) ");
        return std::regex_replace(sentence, ordinal, "");
    }

    static bool ends_with(const std::string& text, const std::string& end)
    {
        return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
    }

    std::string fault_of_pieces() const
    {
        int64_t points = 0, tets = 0;
        for (size_t r = 0; r < ranks_.size(); ++r) {
            const cleft_part* part = ranks_[r].part.get();
            cleft_part_counts counts{};
            counts.struct_size = sizeof counts;
            if (cleft_part_count(part, &counts) != CLEFT_OK)
                return of_rank(r, "has no counts");
            if (counts.all_points != cleft_mesh_point_count(whole_.mesh) ||
                counts.all_tets != cleft_mesh_tet_count(whole_.mesh))
                return of_rank(r, "knows of " + std::to_string(counts.all_tets) + " tetrahedra, but the mesh has " +
                                      std::to_string(cleft_mesh_tet_count(whole_.mesh)));
            if (counts.first_point != points || counts.first_tet != tets)
                return of_rank(r, "does not begin where the rank before ends");
            points += counts.owned_points;
            tets += counts.owned_tets;
            if (!has_same_points(part, counts))
                return of_rank(r, "has other points");
            if (!has_same_tets(part, counts))
                return of_rank(r, "has other tetrahedra");
        }
        return points == cleft_mesh_point_count(whole_.mesh) && tets == cleft_mesh_tet_count(whole_.mesh)
                   ? ""
                   : "some points or tetrahedra are nobody's";
    }

    bool has_same_points(const cleft_part* part, const cleft_part_counts& counts) const
    {
        for (int64_t p = 0; p < counts.points; ++p) {
            const int64_t number = cleft_part_point_numbers(part)[p];
            const bool is_own = cleft_part_point_owners(part)[p] == counts.rank;
            if (number < 0 || number >= counts.all_points || is_own != (p < counts.owned_points) ||
                (is_own && number != counts.first_point + p) ||
                std::memcmp(cleft_part_points(part) + 3 * p, cleft_mesh_points(whole_.mesh) + 3 * number,
                            3 * sizeof(double)))
                return false;
        }
        return true;
    }

    bool has_same_tets(const cleft_part* part, const cleft_part_counts& counts) const
    {
        for (int64_t t = 0; t < counts.owned_tets; ++t) {
            const int64_t number = counts.first_tet + t;
            if (cleft_part_tet_labels(part)[t] != cleft_mesh_tet_labels(whole_.mesh)[number])
                return false;
            for (int64_t c = 0; c < 4; ++c)
                if (cleft_part_point_numbers(part)[cleft_part_tets(part)[4 * t + c]] !=
                    cleft_mesh_tets(whole_.mesh)[4 * number + c])
                    return false;
        }
        return true;
    }

    const std::vector<Rank>& ranks_;
    const WholeMesh& whole_;
};

}  // namespace

std::string fault_of_parts(const Case& drawn, const cleft_options* options, const WholeMesh& whole)
{
    std::vector<Rank> ranks(static_cast<size_t>(drawn.ranks));
    for (Rank& rank : ranks) {
        rank.drawn = &drawn;
        rank.options = options;
    }
    ranks[static_cast<size_t>(drawn.upset_rank)].is_upset = true;
    ranks_run(drawn.ranks, make_part, ranks.data(), sizeof(Rank));
    return PartsChecker(ranks, whole).fault();
}

}  // namespace storm
