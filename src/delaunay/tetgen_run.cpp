// The steps of TetGen's own tetrahedralize(), with one between them: all memory is taken before the points go in.
// TetGen does not test whether its lists got their memory, and loses what it works with where its pools did not.
#ifdef CLEFT_WITH_TETGEN

#include "delaunay/tetgen_run.hpp"

#include "base/error.hpp"

#include <tetgen.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <new>
#include <string>

namespace cleft
{
namespace
{

// With those that close the hull off, points of a background have at most 7 each (tests/delaunay/test_delaunay.cpp);
// those of a small box have most points on its hull.
constexpr long kTetsPerPoint = 8;
constexpr long kTetsOfFewPoints = 64;
// What one point may have in each list while it goes in: those of a background have some hundred.
constexpr int kMostInList = 1 << 16;

// TetGen frees its pools before it throws another code than this, and its destructor would do so again.
constexpr int kOutOfMemory = 1;

void reserve(tetgenmesh::memorypool& pool, long items)
{
    for (long i = 0; i < items; ++i)
        pool.alloc();
    pool.restart();  // keeps the blocks
}

void reserve(tetgenmesh::arraypool& list)
{
    const auto blocks = static_cast<size_t>(kMostInList / list.objectsperblock);
    list.toparray = static_cast<char**>(std::calloc(blocks, sizeof(char*)));
    if (!list.toparray)
        throw std::bad_alloc();
    list.toparraylen = static_cast<int>(blocks);
    const auto bytes = static_cast<size_t>(list.objectbytes) * static_cast<size_t>(list.objectsperblock);
    for (size_t i = 0; i < blocks; ++i) {
        list.toparray[i] = static_cast<char*>(std::malloc(bytes));
        if (!list.toparray[i])
            throw std::bad_alloc();
    }
}

// Leaking a few pools on an error that should not happen is better than freeing them twice.
void forget_pools(tetgenmesh& mesh)
{
    mesh.points = mesh.tetrahedrons = mesh.flippool = nullptr;
    mesh.cavetetlist = nullptr;
}

[[noreturn]] void throw_tetgen_error(int code)
{
    if (code == kOutOfMemory)
        throw std::bad_alloc();
    // TetGen's number for input in one plane, by a tolerance of its own; delaunay.cpp has refused what is so exactly.
    if (code == 10)
        throw Error(CLEFT_ERROR_ARGUMENT, "TetGen found the points to be all but coplanar");
    throw Error(CLEFT_ERROR_INTERNAL, "TetGen failed with its code " + std::to_string(code));
}

void tetrahedralize_reserved(tetgenbehavior& behavior, tetgenio& in, tetgenio& out)
{
    tetgenmesh mesh;
    mesh.b = &behavior;
    mesh.in = &in;
    try {
        mesh.initializepools();
        mesh.transfernodes();
        reserve(*mesh.tetrahedrons, kTetsPerPoint * in.numberofpoints + kTetsOfFewPoints);
        for (auto* list : {mesh.cavetetlist, mesh.cavebdrylist, mesh.caveoldtetlist, mesh.cavetetvertlist})
            reserve(*list);
        exactinit(behavior.verbose, behavior.noexact, behavior.nostaticfilter, mesh.xmax - mesh.xmin,
                  mesh.ymax - mesh.ymin, mesh.zmax - mesh.zmin);
        std::clock_t sorted = 0;
        mesh.incrementaldelaunay(sorted);
        mesh.outelements(&out);
    } catch (int code) {
        if (code != kOutOfMemory)
            forget_pools(mesh);
        throw_tetgen_error(code);
    }
}

}  // namespace

Array<Tet> run_tetgen(Array<Vec3>& points)
{
    // Quiet; zero-based; keep the numbering; no nodes, faces, boundary markers; the tolerance of its test of
    // coplanarity.
    char switches[] = "QzJNFBT1e-15";
    tetgenbehavior behavior;
    if (!behavior.parse_commandline(switches))
        throw Error(CLEFT_ERROR_INTERNAL, "TetGen does not know its switches");
    behavior.no_sort = 1;  // its own sort calls srand() and rand(), which are the program's
    tetgenio in, out;
    // TetGen reads the points in place; its destructor must not free them, however this scope is left.
    struct Lend {
        tetgenio& io;
        ~Lend() { io.pointlist = nullptr; }
    } lend{in};
    in.pointlist = points.data()->data();
    in.numberofpoints = static_cast<int>(points.size());
    tetrahedralize_reserved(behavior, in, out);
    Array<Tet> tets(out.numberoftetrahedra);
    for (size_t t = 0; t < tets.size(); ++t)
        std::copy_n(out.tetrahedronlist + 4 * t, 4, tets[t].begin());
    return tets;
}

}  // namespace cleft

#endif
