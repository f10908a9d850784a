// How many interfaces cross the tetrahedra of a background: what the number of their pieces follows from.
#pragma once

#include "base/fixed_array.hpp"
#include "volume/volume.hpp"

#include <array>

namespace cleft
{

// Of one tetrahedron, or the mean of many.
struct Crossings {
    double tets = 0;                    // 1, or the share that is meant
    FixedArray<double, 4> materials{};  // by the number of materials at the corners, from 1 on: the share that has it
    double cut = 0;                     // the share of edges whose ends have different materials
    double several = 0;                 // the share of edges on which a material lies that neither end has
    double apart = 0;                   // the share of edges whose ends have materials that touch nowhere in the volume

    double alone = 0;  // the share with one corner in a part that is thin there, and three in another material

    // Of one: no interface to snap to is at any of its cuts.
    bool is_held() const { return apart > 0 && apart == cut; }

    void add(const Crossings& other, double weight)
    {
        tets += weight * other.tets;
        for (size_t i = 0; i < 4; ++i)
            materials[i] += weight * other.materials[i];
        several += weight * other.several;
        apart += weight * other.apart;
        cut += weight * other.cut;
        alone += weight * other.alone;
    }
};

// Those that may snap, and those that are held.
struct MeanCrossings {
    Crossings free, held;

    void add(const Crossings& tet, double weight) { (tet.is_held() ? held : free).add(tet, weight); }
    MeanCrossings times(double factor) const
    {
        MeanCrossings out;
        out.free.add(free, factor);
        out.held.add(held, factor);
        return out;
    }
    double tets() const { return free.tets + held.tets; }
    double several() const { return free.several + held.several; }
};

class CrossingCounter
{
public:
    CrossingCounter(const Volume& volume, const Run& run);

    Crossings crossings(const std::array<Vec3, 4>& corners) const;

private:
    bool touch(Material a, Material b) const;
    bool has_one_alone(const std::array<Vec3, 4>& corners, const std::array<Material, 4>& materials) const;
    bool has_another_between(const Vec3& a, const Vec3& b, Material of_a, Material of_b) const;

    const Volume& volume_;
    Array<uint8_t> touch_;  // by pair of materials; empty: all do
};

}  // namespace cleft
