// Makes a change that was found: at once, or with others side by side.
#include "remeshing/proposal.hpp"

#include "remeshing/edge_split.hpp"

namespace cleft
{

void Proposal::make(LocalMesh& mesh)
{
    begin(mesh);
    make(mesh, 0);
    end(mesh);
}

void Proposal::begin(LocalMesh& mesh)
{
    CLEFT_ASSERT(kind != Kind::none);
    if (kind == Kind::split)
        cavity.number_new_point(mesh.add_point(place, frozen_on_edge(mesh, cavity.ring)));
    if (kind != Kind::move)
        cavity.reserve(mesh);
}

void Proposal::make(LocalMesh& mesh, int worker)
{
    if (kind == Kind::move)
        mesh.move(point, place);
    else
        cavity.refill(mesh, worker);
}

void Proposal::end(LocalMesh& mesh)
{
    if (kind != Kind::move)
        cavity.release(mesh);
}

}  // namespace cleft
