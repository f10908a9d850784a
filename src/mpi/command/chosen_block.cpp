// Slabs follow from the volume, the options and the bound of memory alone, so that the mesh does not depend on ranks.
#include "mpi/command/chosen_block.hpp"

#include "mpi/command/memory_bound.hpp"

#include <algorithm>

namespace cleft_mpi_cli
{
namespace
{

using cleft_cli::Session;

// Slabs that ranks share where nobody chose any: they follow from the volume, so that the mesh does. 0: it is too thin.
int64_t block_to_share(int64_t planes)
{
    // Thinner slabs are mostly seams. Who has more ranks than slabs has a reason to choose.
    constexpr int64_t kThinnest = 32, kSlabs = 16;
    return planes < 2 * kThinnest ? 0 : std::max(kThinnest, planes / kSlabs);
}

int64_t integer_of(Session& session, const cleft_options* options, cleft_option key)
{
    int64_t value = 0;
    session.check(cleft_options_get_integer(options, key, &value), cleft_cli::EXIT_USAGE);
    return value;
}

// With these options the first rank makes the whole mesh, whatever the slabs are.
bool is_made_by_one(Session& session, const cleft_options* options)
{
    double anisotropy = 1;
    session.check(cleft_options_get_real(options, CLEFT_OPTION_ANISOTROPY, &anisotropy), cleft_cli::EXIT_USAGE);
    return anisotropy > 1 || integer_of(session, options, CLEFT_OPTION_TETS) > 0 ||
           integer_of(session, options, CLEFT_OPTION_STRICT) != 0;
}

}  // namespace

void choose_block(const Ranks& ranks, Session& session, const PartsArguments& arguments, const cleft_voxels& voxels,
                  cleft_options* options)
{
    const bool is_bounded = !arguments.memory.empty();
    if (arguments.options.has(CLEFT_OPTION_BLOCK) || is_made_by_one(session, options))
        return;
    const int64_t block = is_bounded ? block_within(bytes_of_size(arguments.memory), arguments.memory, voxels.dims)
                                     : block_to_share(voxels.dims[2]);
    session.check(cleft_options_set_integer(options, CLEFT_OPTION_BLOCK, block), cleft_cli::EXIT_USAGE);
    if (!ranks.is_first() || block == 0)
        return;
    const std::string planes = std::to_string(block);
    session.warn(is_bounded ? "--memory " + arguments.memory + " has the mesh made in slabs of " + planes +
                                  " planes: it is that of --block " + planes
                            : "ranks share slabs of " + planes + " planes: the mesh is that of --block " + planes +
                                  "; --block 0 has the first rank make it as a whole");
}

}  // namespace cleft_mpi_cli
