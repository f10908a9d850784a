// How many tetrahedra the finished mesh of a sizing field will have: those of the background, and what cleaving makes
// of those that interfaces pass through.
#pragma once

#include "sizing/sizing.hpp"
#include "volume/volume.hpp"

#include <vector>

namespace cleft
{

struct ExpectedMesh {
    double tets = 0;
    double kept = 0;        // of the materials that are kept
    bool is_bound = false;  // there may be fewer: labels have so few points each that most of the cuts may have to stay
};

// By a sample of tetrahedra at random places (the same ones each time). keep[material] != 0, all if it is empty.
ExpectedMesh expected_mesh(const SizingField& field, const Volume& volume, const std::vector<char>& keep,
                           const Run& run);

}  // namespace cleft
