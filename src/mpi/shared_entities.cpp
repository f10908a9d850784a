// Whoever has something tells the owner of its least point, who tells all of them of each other. An edge can be shared
// only where both its ends are, so few of them travel.
#include "mpi/shared_entities.hpp"

#include <algorithm>

namespace cleft::mpi
{

namespace
{

using Ranks = std::vector<int32_t>;

// Corners by their numbers in the whole mesh, ascending, and by those of the part.
template <size_t N>
struct Entity {
    std::array<int64_t, N> numbers;
    std::array<int32_t, N> local;
    bool operator<(const Entity& other) const { return numbers < other.numbers; }
    bool operator==(const Entity& other) const { return numbers == other.numbers; }
};

template <size_t N>
Entity<N> entity_of(const PartView& part, std::array<int32_t, N> corners)
{
    std::sort(corners.begin(), corners.end(), [&](int32_t a, int32_t b) { return part.numbers[a] < part.numbers[b]; });
    Entity<N> entity{{}, corners};
    for (size_t i = 0; i < N; ++i)
        entity.numbers[i] = part.numbers[corners[i]];
    return entity;
}

template <class T>
void sort_and_drop_doubles(std::vector<T>& items)
{
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

// What an owner heard of: who has it, and as which of the items that came.
template <size_t N>
struct Heard {
    std::array<int64_t, N> numbers;
    int32_t rank;
    int64_t place;
    bool operator<(const Heard& other) const
    {
        return numbers != other.numbers ? numbers < other.numbers : rank < other.rank;
    }
};

// For each item that came: the ranks that sent it.
template <size_t N>
std::vector<Ranks> senders_of(const Received<std::array<int64_t, N>>& arrived, int32_t ranks)
{
    std::vector<Heard<N>> heard;
    heard.reserve(arrived.items.size());
    for (int32_t r = 0; r < ranks; ++r)
        for (int64_t i = arrived.start[r]; i < arrived.start[r + 1]; ++i)
            heard.push_back({arrived.items[i], r, i});
    std::sort(heard.begin(), heard.end());
    std::vector<Ranks> senders(heard.size());
    for (size_t first = 0, end = 0; first < heard.size(); first = end) {
        Ranks all;
        for (end = first; end < heard.size() && heard[end].numbers == heard[first].numbers; ++end)
            all.push_back(heard[end].rank);
        for (size_t i = first; i < end; ++i)
            senders[to_size(heard[i].place)] = all;
    }
    return senders;
}

// For each entity the ranks that have it.
template <size_t N>
std::vector<Ranks> ranks_of(const PartView& part, const std::vector<Entity<N>>& entities, Exchange& exchange)
{
    const int32_t ranks = exchange.ranks();
    Array<Array<std::array<int64_t, N>>> asked(to_size(ranks));
    for (const Entity<N>& entity : entities)
        asked[part.owners[entity.local[0]]].push_back(entity.numbers);
    const auto arrived = exchange.all_to_all(asked);
    const std::vector<Ranks> senders = senders_of(arrived, ranks);
    // Lists of ranks, each after its length.
    Array<Array<int32_t>> told(to_size(ranks));
    for (int32_t r = 0; r < ranks; ++r)
        for (int64_t i = arrived.start[r]; i < arrived.start[r + 1]; ++i) {
            const Ranks& list = senders[to_size(i)];
            told[r].push_back(static_cast<int32_t>(list.size()));
            told[r].insert(told[r].end(), list.begin(), list.end());
        }
    const auto answers = exchange.all_to_all(told);
    Array<int64_t> at = answers.start;
    std::vector<Ranks> out;
    for (const Entity<N>& entity : entities) {
        int64_t& next = at[part.owners[entity.local[0]]];
        const int32_t count = answers.items[next++];
        out.emplace_back(answers.items.begin() + next, answers.items.begin() + next + count);
        next += count;
    }
    return out;
}

// Asks for the ranks of entities, and adds those of several ranks to their groups.
template <size_t N, class Add>
void share_out(const PartView& part, std::vector<Entity<N>>& entities, Exchange& exchange, const Add& add)
{
    sort_and_drop_doubles(entities);
    const std::vector<Ranks> ranks = ranks_of(part, entities, exchange);
    for (size_t i = 0; i < entities.size(); ++i)
        if (ranks[i].size() > 1)
            add(ranks[i], entities[i].local);
}

std::vector<Entity<1>> points_of_tets(const PartView& part)
{
    std::vector<char> is_used(to_size(part.counts.points), 0);
    for (int64_t i = 0; i < 4 * part.counts.owned_tets; ++i)
        is_used[to_size(part.tets[i])] = 1;
    std::vector<Entity<1>> points;
    for (size_t p = 0; p < is_used.size(); ++p)
        if (is_used[p])
            points.push_back(entity_of<1>(part, {static_cast<int32_t>(p)}));
    return points;
}

// The edges or triangles of owned tetrahedra, of shared points alone.
template <size_t N, size_t Count>
std::vector<Entity<N>> between_shared(const PartView& part, const std::vector<char>& is_shared,
                                      const std::array<std::array<int, N>, Count>& sides)
{
    std::vector<Entity<N>> found;
    for (int64_t t = 0; t < part.counts.owned_tets; ++t)
        for (const auto& side : sides) {
            std::array<int32_t, N> corners{};
            bool all_shared = true;
            for (size_t i = 0; i < N; ++i) {
                corners[i] = part.tets[4 * t + side[i]];
                all_shared = all_shared && is_shared[to_size(corners[i])];
            }
            if (all_shared)
                found.push_back(entity_of<N>(part, corners));
        }
    return found;
}

constexpr std::array<std::array<int, 2>, 6> kEdgesOfTet{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<int, 3>, 4> kFacesOfTet{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};

}  // namespace

std::map<Ranks, SharedEntities> shared_entities(const PartView& part, Exchange& exchange)
{
    std::map<Ranks, SharedEntities> groups;
    std::vector<char> is_shared(to_size(part.counts.points), 0);
    std::vector<Entity<1>> points = points_of_tets(part);
    share_out(part, points, exchange, [&](const Ranks& ranks, const std::array<int32_t, 1>& point) {
        is_shared[to_size(point[0])] = 1;
        groups[ranks].points.push_back(point);
    });
    auto edges = between_shared(part, is_shared, kEdgesOfTet);
    share_out(part, edges, exchange,
              [&](const Ranks& ranks, const std::array<int32_t, 2>& edge) { groups[ranks].edges.push_back(edge); });
    auto triangles = between_shared(part, is_shared, kFacesOfTet);
    share_out(part, triangles, exchange, [&](const Ranks& ranks, const std::array<int32_t, 3>& triangle) {
        groups[ranks].triangles.push_back(triangle);
    });
    return groups;
}

}  // namespace cleft::mpi
