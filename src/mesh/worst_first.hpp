// The order of work of every local search here: bad tetrahedra, the worst first, those that the last pass left or made.
#pragma once

#include "mesh/local_mesh.hpp"

namespace cleft
{

class WorstFirst
{
public:
    // Every tetrahedron of the mesh with a quality below `target`.
    void collect_all(const LocalMesh& mesh, double target);
    // The tetrahedra named by add() since the last collection that are alive and below the target, each once.
    void collect_added(const LocalMesh& mesh, double target);
    void add(const std::vector<int32_t>& tets) { added_.insert(added_.end(), tets.begin(), tets.end()); }
    void add(int32_t t) { added_.push_back(t); }

    const std::vector<int32_t>& order() const { return order_; }

private:
    struct Bad {
        double quality;
        int32_t tet;
    };

    void sort();

    std::vector<Bad> bad_;
    std::vector<int32_t> order_, added_;
};

}  // namespace cleft
