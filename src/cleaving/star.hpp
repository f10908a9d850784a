// Everything around a vertex that moves with it.
#pragma once

#include "cleaving/centres.hpp"

namespace cleft
{

// Which tetrahedra have a vertex as a corner, for vertices at edges that were cut at the start.
class VertexTets
{
public:
    explicit VertexTets(const Centres& c);

    const int32_t* begin(int32_t v) const { return tets_.data() + first_[static_cast<size_t>(v)]; }
    const int32_t* end(int32_t v) const { return tets_.data() + first_[static_cast<size_t>(v) + 1]; }
    // Ascending.
    const std::vector<int32_t>& vertices() const { return vertices_; }

private:
    std::vector<int32_t> vertices_;
    std::vector<int64_t> first_;
    std::vector<int32_t> tets_;
};

// The tetrahedra around a vertex and its edges with a cut: all other centres around it follow from these.
struct Star {
    int32_t vertex = -1;
    std::vector<int32_t> tets;
    std::vector<int32_t> edges;  // still cut
    double shortest_edge = 0;

    // Replaces what was gathered before.
    void gather(const Centres& c, const VertexTets& tets_of, int32_t v);
};

// The part of the state that a change of the vertex touches, to go back to.
struct StarState {
    Vec3 x;
    MaterialSet materials;
    SampleStore::Span samples{};
    std::vector<CutEdge> edges;

    void save(const Centres& c, const Star& star);
    void restore(Centres& c, const Star& star) const;
};

// Gives the vertex a place and materials, and finds the cuts around it anew.
void change_vertex(Centres& c, const Star& star, const Vec3& x, const MaterialSet& materials,
                   const SampleStore::Span& samples, Samples& scratch);

// How well shaped the star is.
struct StarShape {
    double cost = 0;              // of the tetrahedra that it splits into, see BestFan::cost
    double least_background = 1;  // least sine of the background tetrahedra themselves
};

// Stops early, with the cost so far, once that is above `limit`.
StarShape measure_star(const Centres& c, const Star& star, double limit);

}  // namespace cleft
