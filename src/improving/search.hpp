// What one search of improving may do, and what it did.
#pragma once

#include "remeshing/local_mesh.hpp"

namespace cleft
{

// Passes over the tetrahedra below the target.
// A later search of improve() may do more than the one before, on the few tetrahedra that are left.
struct Search {
    int passes;
    double tolerance = 0;   // how far points of interfaces may leave the tie, in least voxel spacings (or edge
                            // lengths, where those are shorter)
    double bend = 0.05;     // how far an interface may move when an edge in it is flipped, in lengths of the edge
    bool thorough = false;  // only for the worst, if there are many: also tries places far from where a point is
    bool compound = false;  // also tries operations that help only after the points around have moved
    bool wide = false;      // compound operations at the tetrahedra around, too
    int32_t most_tets = INT32_MAX;  // a mesh of so many gets no points more
};

struct SearchCounts {
    // At which the shapes around a point were looked at. This takes most of the time, so it measures the work: a
    // tetrahedron takes from one place to some thousands.
    int64_t places = 0;
    int64_t tried = 0;  // tetrahedra, each time that one was
    int64_t moved = 0, edges_removed = 0, faces_removed = 0, contracted = 0, split = 0, compound = 0;
};

// After so much work, searches and tries end. At 32 degrees, clean volumes take 3 places for each tetrahedron of the
// mesh, and labels of random voxels up to 100.
inline int64_t most_places(const LocalMesh& mesh)
{
    constexpr int64_t kPlacesAtLeast = 1'000'000;  // so that small meshes have all of their tries
    constexpr int64_t kPlacesEach = 120;
    constexpr int64_t kMeasuredCost = 8;  // of a place in a mesh that is measured by a metric
    return (kPlacesAtLeast + kPlacesEach * mesh.slot_count()) / (mesh.is_measured() ? kMeasuredCost : 1);
}

// How far the interface may move when this edge is flipped.
inline double bend_at(const LocalMesh& mesh, const Search& search, int32_t t, int corner_a, int corner_b)
{
    const Tet& v = mesh.tet(t);
    const int32_t a = v[corner_a], b = v[corner_b];
    return search.bend * mesh.measured_on_edge(a, b, mesh.point(a) - mesh.point(b)).norm();
}

}  // namespace cleft
