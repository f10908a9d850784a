// The points of one place go to one rank. Numbers that are made of the places go first, since they are shorter.
#include "parts/repeated_places.hpp"

#include "checking/quick_check.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// What ranks have of points, sorted. `item(p)`: of the point p.
template <class T, class Item, class Less>
bool has_twins(const Array<Vec3>& points, int64_t count, const Item& item, const Less& less, Exchange& exchange)
{
    Array<Array<T>> sent(to_size(exchange.ranks()));
    for (int64_t p = 0; p < count; ++p)
        sent[hash_of_place(points[p]) % static_cast<uint64_t>(exchange.ranks())].push_back(item(points[p]));
    Array<T> here = exchange.all_to_all(sent).items;
    std::sort(here.begin(), here.end(), less);
    const auto twin = std::adjacent_find(here.begin(), here.end(), [&](const T& a, const T& b) { return !less(a, b); });
    const Array<int64_t> found = exchange.all_gather(int64_t{twin != here.end()});
    return std::find(found.begin(), found.end(), 1) != found.end();
}

}  // namespace

bool has_repeated_places(const Array<Vec3>& points, int64_t count, Exchange& exchange)
{
    return has_twins<uint64_t>(points, count, hash_of_place, std::less<>(), exchange) &&
           has_twins<Vec3>(
               points, count, [](const Vec3& x) { return x; }, is_before, exchange);
}

}  // namespace cleft
