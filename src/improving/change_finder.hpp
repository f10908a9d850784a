// What may help a bad tetrahedron: the operations of improving, in their order.
#pragma once

#include "improving/constrained_smoother.hpp"
#include "improving/search.hpp"
#include "remeshing/contraction.hpp"
#include "remeshing/proposal.hpp"

namespace cleft
{

class ChangeFinder
{
public:
    // `home`: see TieConstraint.
    ChangeFinder(const LocalMesh& mesh, const Volume& volume, const Array<Vec3>& home)
        : mesh_(mesh), smoother_(mesh, volume, home)
    {
    }

    // `target`: of shape_quality.
    void aim_at(double target, const Search& search)
    {
        search_ = search;
        smoother_.aim_at(target, search.tolerance);
    }
    // Steps 0 to 3 move a corner each, step 4 changes connections. See Rounds::Find.
    int find(int32_t t, int step, Proposal& proposal);
    // See Smoother.
    int64_t places() const { return smoother_.places(); }

private:
    bool find_move(int32_t v, Proposal& proposal);
    bool find_new_connections(int32_t t, Proposal& proposal);
    bool find_split(int32_t t, int corner_a, int corner_b, Proposal& proposal);

    const LocalMesh& mesh_;
    Search search_{};
    ConstrainedSmoother smoother_;
    Contraction contraction_;
};

}  // namespace cleft
