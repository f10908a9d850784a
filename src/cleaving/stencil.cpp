// Splits the faces of a tetrahedron by the rules of stencil.hpp, and finds the points that it may be fanned around.
#include "cleaving/stencil.hpp"

namespace cleft
{

namespace
{

bool in_face(int point, size_t face) { return !(kCarrier[point] >> face & 1u); }

bool has_corner(const StencilTriangle& triangle, int point)
{
    return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

// Writes the triangles of one face behind the others.
class FaceSplitter
{
public:
    FaceSplitter(size_t face, CutMask cuts, Diagonals diagonals, SplitSurface& out)
        : face_(face), cuts_(cuts), higher_is_greater_(diagonals >> face & 1u), out_(out), end_(out.first[face])
    {
    }

    void split()
    {
        int count = 0, last_cut = 0, last_whole = 0;
        for (int side = 0; side < 3; ++side) {
            const bool is_cut = cuts_ >> edge(side) & 1u;
            count += is_cut;
            (is_cut ? last_cut : last_whole) = side;
        }
        switch (count) {
            case 0:
                add(corner(0), corner(1), corner(2));
                break;
            case 1:
                split_by_one(last_cut);
                break;
            case 2:
                split_by_two(last_whole);
                break;
            default:
                split_by_three();
        }
        out_.first[face_ + 1] = static_cast<uint8_t>(end_);
    }

private:
    // Side k runs from corner k to corner k + 1.
    int corner(int k) const { return kFaceCorners[face_][k % 3]; }
    int edge(int side) const { return kEdgeBetween[corner(side)][corner(side + 1)]; }
    int cut(int side) const { return kCutPoint + edge(side); }

    void add(int a, int b, int c)
    {
        out_.triangles[end_++] = {static_cast<uint8_t>(a), static_cast<uint8_t>(b), static_cast<uint8_t>(c)};
    }

    void split_by_one(int side)
    {
        add(corner(side), cut(side), corner(side + 2));
        add(cut(side), corner(side + 1), corner(side + 2));
    }

    // The triangle between the cuts is the same for both diagonals. Points of cuts are numbered like edges, so p > q
    // compares the numbers of the edges.
    void split_by_two(int whole_side)
    {
        const int a = corner(whole_side), b = corner(whole_side + 1), between = corner(whole_side + 2);
        const int p = cut(whole_side + 1), q = cut(whole_side + 2);
        add(p, between, q);
        if ((p > q) == higher_is_greater_) {
            add(p, q, a);
            add(p, a, b);
        } else {
            add(q, a, b);
            add(q, b, p);
        }
    }

    void split_by_three()
    {
        const int triple = kTriplePoint + static_cast<int>(face_);
        for (int side = 0; side < 3; ++side) {
            add(triple, corner(side), cut(side));
            add(triple, cut(side), corner(side + 1));
        }
    }

    size_t face_;
    CutMask cuts_;
    bool higher_is_greater_;
    SplitSurface& out_;
    size_t end_;
};

bool is_there(int point, CutMask cuts)
{
    if (point < kCutPoint)
        return true;
    if (point < kTriplePoint)
        return cuts >> (point - kCutPoint) & 1u;
    const CutMask needed = kFaceCuts[point - kTriplePoint];
    return (cuts & needed) == needed;
}

// The condition of lemma 1: each face that holds the point is a fan around it.
bool is_apex(int point, const SplitSurface& surface)
{
    for (size_t face = 0; face < 4; ++face)
        if (in_face(point, face))
            for (size_t i = surface.first[face]; i < surface.first[face + 1]; ++i)
                if (!has_corner(surface.triangles[i], point))
                    return false;
    return true;
}

}  // namespace

Diagonals diagonals(CutMask cuts, const CutRanks& ranks)
{
    Diagonals diagonals = 0;
    for (size_t face = 0; face < 4; ++face) {
        size_t found[3], count = 0;
        for (size_t e = 0; e < 6; ++e)
            if ((cuts & kFaceCuts[face]) >> e & 1u)
                found[count++] = e;
        if (count == 2 && ranks[found[1]] > ranks[found[0]])
            diagonals |= 1u << face;
    }
    return diagonals;
}

SplitSurface split_surface(CutMask cuts, Diagonals diagonals)
{
    SplitSurface surface;
    for (size_t face = 0; face < 4; ++face)
        FaceSplitter(face, cuts, diagonals, surface).split();
    return surface;
}

Apexes apexes(CutMask cuts, const SplitSurface& surface)
{
    Apexes found;
    if (cuts == kAllCuts || cuts == 0) {
        found.point[0] = cuts == 0 ? 0 : kQuadruplePoint;
        found.count = 1;
        return found;
    }
    for (int point = 0; point < kQuadruplePoint; ++point)
        if (is_there(point, cuts) && is_apex(point, surface))
            found.point[found.count++] = static_cast<uint8_t>(point);
    return found;
}

int fan(const SplitSurface& surface, int apex, FixedArray<StencilTet, 24>& out)
{
    int count = 0;
    for (size_t face = 0; face < 4; ++face)
        if (!in_face(apex, face))
            for (size_t i = surface.first[face]; i < surface.first[face + 1]; ++i) {
                const StencilTriangle& t = surface.triangles[i];
                out[count++] = {t[0], t[2], t[1], static_cast<uint8_t>(apex)};
            }
    return count;
}

}  // namespace cleft
