// Where an interface of two materials is no surface. Standard C++ alone, so that tests of the C interface can use it
// too.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace cleft_test
{

// Edges and points with two labels in more parts, each of tetrahedra that hang together there, than an interface that
// is a surface leaves: two.
struct Pinches {
    int64_t edges = 0, points = 0;
};

// Plain sorting and searching.
template <class Tets>  // an array of four corners each
class PinchCounter
{
public:
    PinchCounter(const Tets& tets, const std::vector<int32_t>& labels) : tets_(tets), labels_(labels)
    {
        join_over_faces();
    }

    Pinches count() const
    {
        Pinches pinches;
        pinches.edges = count_among<2>();
        pinches.points = count_among<1>();
        return pinches;
    }

private:
    template <size_t n>
    struct Use {
        std::array<int32_t, n> simplex;
        int32_t tet;
        bool operator<(const Use& o) const { return simplex != o.simplex ? simplex < o.simplex : tet < o.tet; }
    };

    // All simplices of n corners of all tetrahedra, each with its tetrahedra side by side.
    template <size_t n>
    std::vector<Use<n>> uses() const
    {
        std::vector<Use<n>> all;
        for (size_t t = 0; t < tets_.size(); ++t)
            for (unsigned subset = 1; subset < 16; ++subset) {
                Use<n> use{{}, static_cast<int32_t>(t)};
                size_t chosen = 0;
                for (size_t i = 0; i < 4; ++i)
                    if (subset >> i & 1u) {
                        if (chosen < n)
                            use.simplex[chosen] = tets_[t][i];
                        ++chosen;
                    }
                if (chosen != n)
                    continue;
                std::sort(use.simplex.begin(), use.simplex.end());
                all.push_back(use);
            }
        std::sort(all.begin(), all.end());
        return all;
    }

    void join_over_faces()
    {
        neighbours_.assign(tets_.size(), {});
        const std::vector<Use<3>> faces = uses<3>();
        for (size_t i = 1; i < faces.size(); ++i)
            if (faces[i].simplex == faces[i - 1].simplex) {
                neighbours_[static_cast<size_t>(faces[i].tet)].push_back(faces[i - 1].tet);
                neighbours_[static_cast<size_t>(faces[i - 1].tet)].push_back(faces[i].tet);
            }
    }

    template <size_t n>
    int64_t count_among() const
    {
        const std::vector<Use<n>> all = uses<n>();
        int64_t pinched = 0;
        std::vector<int32_t> around;
        for (size_t first = 0, last = 0; first < all.size(); first = last) {
            around.clear();
            for (; last < all.size() && all[last].simplex == all[first].simplex; ++last)
                around.push_back(all[last].tet);
            pinched += is_pinched(around, all[first].simplex);
        }
        return pinched;
    }

    template <size_t n>
    bool is_pinched(const std::vector<int32_t>& around, const std::array<int32_t, n>& simplex) const
    {
        const int32_t one = label(around.front());
        int32_t two = one;
        for (const int32_t t : around) {
            if (label(t) != one && two == one)
                two = label(t);
            if (label(t) != one && label(t) != two)
                return false;
        }
        return one != two && count_parts(around, simplex) > 2;
    }

    // Of tetrahedra that share the simplex: how many parts of one label, joined over faces that have it too.
    template <size_t n>
    int count_parts(const std::vector<int32_t>& around, const std::array<int32_t, n>& simplex) const
    {
        std::vector<size_t> part(around.size());
        std::iota(part.begin(), part.end(), size_t{0});
        int parts = static_cast<int>(around.size());
        for (size_t i = 0; i < around.size(); ++i)
            for (const int32_t other : neighbours_[static_cast<size_t>(around[i])]) {
                const auto found = std::lower_bound(around.begin(), around.end(), other);
                if (found == around.end() || *found != other || !share_beside(around[i], other, simplex))
                    continue;
                const size_t from = part[static_cast<size_t>(found - around.begin())], to = part[i];
                parts -= from != to;
                std::replace(part.begin(), part.end(), from, to);
            }
        return parts;
    }

    // Tetrahedra that share a face, of one label, whose face has all corners of the simplex.
    template <size_t n>
    bool share_beside(int32_t a, int32_t b, const std::array<int32_t, n>& simplex) const
    {
        const auto& other = tets_[static_cast<size_t>(b)];
        return label(a) == label(b) && std::all_of(simplex.begin(), simplex.end(), [&](int32_t v) {
                   return std::find(other.begin(), other.end(), v) != other.end();
               });
    }

    int32_t label(int32_t tet) const { return labels_[static_cast<size_t>(tet)]; }

    const Tets& tets_;
    const std::vector<int32_t>& labels_;
    std::vector<std::vector<int32_t>> neighbours_;
};

template <class Tets>
Pinches count_pinches(const Tets& tets, const std::vector<int32_t>& labels)
{
    return PinchCounter<Tets>(tets, labels).count();
}

}  // namespace cleft_test
