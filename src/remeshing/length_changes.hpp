// Changes that bring the lengths of edges, in the metric that a mesh is measured by, near to one.
#pragma once

#include "remeshing/contraction.hpp"
#include "remeshing/proposal.hpp"
#include "remeshing/tet_star.hpp"

namespace cleft
{

// An edge of more than sqrt(2) makes two that are nearer to one than it was, and one of less than sqrt(1/2) is nearer
// to none. All is a little shorter, so that a mesh has as many points as others make of a metric: twice the integral of
// the root of its determinant.
inline constexpr double kShortest = 0.68, kLongest = 1.33;
// That a contraction makes: longer ones would only be split again.
inline constexpr double kLongestMade = 1.5;

// What lengths are wanted, and what is given for them.
struct LengthGoal {
    double shortest, longest;       // of edges
    double longest_made;            // that a contraction makes
    double enough;                  // of shape_quality: no contraction is refused for shapes that are better
    int32_t most_tets = INT32_MAX;  // a mesh of so many gets no points more
};

// Keeps its memory between calls.
class LengthChanges
{
public:
    LengthChanges(const LocalMesh& mesh, const LengthGoal& goal) : mesh_(mesh), goal_(goal) {}

    // To put a point into the middle of the longest edge of the tetrahedron. Kind::none if that cannot be.
    void find_split(int32_t t, Proposal& proposal);
    // To contract one of its short edges, the shortest first.
    void find_contraction(int32_t t, Proposal& proposal);

private:
    bool are_positive(const Proposal& proposal) const;
    bool makes_no_long_edge(int32_t gone, int32_t kept);

    const LocalMesh& mesh_;
    const LengthGoal& goal_;
    Contraction contraction_;
    TetStar star_;
};

double longest_edge(const LocalMesh& mesh, int32_t t);
double shortest_edge(const LocalMesh& mesh, int32_t t);

}  // namespace cleft
