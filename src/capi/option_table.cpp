#include "capi/option_table.hpp"

#include "volume/limits.hpp"

namespace cleft::capi
{

namespace
{
constexpr double kMost = kGreatestSize;
constexpr double kWhole = 9007199254740992.0;  // 2^53: the whole numbers that a double holds exactly
}  // namespace

const OptionRow kOptionTable[kOptionCount] = {
    {CLEFT_OPTION_BACKGROUND, CLEFT_OPTION_TYPE_CHOICE, "background", CLEFT_BACKGROUND_PARTICLES, 0, 2,
     "particles|lattice|octree", "kind of background mesh"},
    {CLEFT_OPTION_SIZE, CLEFT_OPTION_TYPE_REAL, "size", 0, 0, kMost, "",
     "one wanted edge length everywhere, in world units; 0: computed from the features of the volume"},
    {CLEFT_OPTION_SIZE_MIN, CLEFT_OPTION_TYPE_REAL, "size_min", 0, 0, kMost, "",
     "least wanted edge length, in world units; 0: the least voxel spacing"},
    {CLEFT_OPTION_SIZE_MAX, CLEFT_OPTION_TYPE_REAL, "size_max", 0, 0, kMost, "",
     "greatest wanted edge length, in world units (single edges come out up to 2.3 times as long); 0: a quarter of "
     "the longest side of the box, or its thickness times 1.5 if that is less"},
    {CLEFT_OPTION_FEATURE_SCALE, CLEFT_OPTION_TYPE_REAL, "feature_scale", 1, 1e-3, 1e3, "",
     "edge length at an interface over the local feature size; 0.5 is fine, 2 is coarse"},
    {CLEFT_OPTION_GRADATION, CLEFT_OPTION_TYPE_REAL, "gradation", 0.3, 0.01, 1, "",
     "greatest growth of the edge length over a distance (Lipschitz constant of the sizing field)"},
    {CLEFT_OPTION_INTERFACE_SIZE, CLEFT_OPTION_TYPE_REAL, "interface_size", 0, 0, kMost, "",
     "greatest wanted edge length at interfaces, in world units; 0: none"},
    {CLEFT_OPTION_KEEP_THIN, CLEFT_OPTION_TYPE_FLAG, "keep_thin", 0, 0, 1, "",
     "edges of half the least voxel spacing, or of size_min, where a label is one voxel thick, so that such parts come "
     "out whole"},
    {CLEFT_OPTION_TETS, CLEFT_OPTION_TYPE_INTEGER, "tets", 0, 0, 2147483647.0, "",
     "wanted number of tetrahedra, of the labels that are kept, met within 10 %; 0: as the sizes say"},
    {CLEFT_OPTION_MAX_TETS, CLEFT_OPTION_TYPE_INTEGER, "max_tets", 10000000, 0, 2147483647.0, "",
     "where size_min is 0, the least edge length is raised until no more background tetrahedra than about these are "
     "expected, and where tets counts some labels only, the whole mesh keeps to these; 0: no limit"},
    {CLEFT_OPTION_SMOOTH, CLEFT_OPTION_TYPE_INTEGER, "smooth", 5, 2, 6, "",
     "width in voxels of the kernel that smooths label maps, when the volume is made"},
    {CLEFT_OPTION_SNAP, CLEFT_OPTION_TYPE_CHOICE, "snap", CLEFT_SNAP_QUALITY, 0, 2, "quality|safe|none",
     "rule that moves background points onto interfaces: quality of the elements around, the paper's safe distances, "
     "or none"},
    {CLEFT_OPTION_IMPROVE, CLEFT_OPTION_TYPE_CHOICE, "improve", CLEFT_IMPROVE_FAST, 0, 2, "off|fast|best",
     "effort spent on the worst dihedral angles after cleaving"},
    {CLEFT_OPTION_STEPS, CLEFT_OPTION_TYPE_INTEGER, "steps", 8, 0, 1000, "", "relaxation steps of the particles"},
    {CLEFT_OPTION_SEED, CLEFT_OPTION_TYPE_INTEGER, "seed", 0, 0, kWhole, "",
     "varies the arrangement of the particles; the same seed gives the same mesh"},
    {CLEFT_OPTION_STRICT, CLEFT_OPTION_TYPE_FLAG, "strict", 0, 0, 1, "",
     "fail when a kept label, or a piece of more than 30 voxels of one, is lost or breaks, or when two kept labels "
     "meet "
     "that do not in the voxels"},
    {CLEFT_OPTION_REPAIR, CLEFT_OPTION_TYPE_REAL, "repair", 30, 0, 35, "",
     "dihedral angle in degrees below which tetrahedra of a background from a file are repaired before cleaving; 0: "
     "none"},
};

int option_row(cleft_option key)
{
    for (size_t i = 0; i < kOptionCount; ++i)
        if (kOptionTable[i].key == key)
            return static_cast<int>(i);
    return -1;
}

int option_row(const char* name)
{
    for (size_t i = 0; i < kOptionCount; ++i) {
        const char* a = kOptionTable[i].name;
        const char* b = name;
        while (*a && (*a == *b || (*a == '_' && *b == '-'))) {
            ++a;
            ++b;
        }
        if (!*a && !*b)
            return static_cast<int>(i);
    }
    return -1;
}

}  // namespace cleft::capi
