// Numbers volumes and groups of triangles so that no two have the same number.
#include "io/group_numbers.hpp"

#include <algorithm>
#include <limits>

namespace cleft::io
{

namespace
{

// Hands out the positive numbers that are not in an ascending list, the least one first.
class FreeNumbers
{
public:
    explicit FreeNumbers(const std::vector<int32_t>& taken) : taken_(taken) {}

    int32_t next()
    {
        while (std::binary_search(taken_.begin(), taken_.end(), next_))
            ++next_;
        return next_++;
    }

private:
    const std::vector<int32_t>& taken_;
    int32_t next_ = 1;
};

}  // namespace

void number_groups(MeshView& mesh)
{
    // Users look for label 3 under number 3. Gmsh wants positive numbers, so 0 and negative labels
    // cannot keep theirs.
    mesh.volume_numbers = mesh.labels;
    FreeNumbers free_of_labels(mesh.labels);
    for (int32_t& number : mesh.volume_numbers)
        if (number <= 0)
            number = free_of_labels.next();

    std::vector<int32_t> taken = mesh.volume_numbers;
    std::sort(taken.begin(), taken.end());
    const int64_t greatest = taken.empty() ? 0 : taken.back();
    // A label near 2^31 leaves no room above it. The sum is made in 64 bits.
    const int64_t room = std::numeric_limits<int32_t>::max() - greatest;
    const bool fits = static_cast<int64_t>(mesh.groups.size()) <= room;
    FreeNumbers free_of_volumes(taken);
    int64_t above = greatest;
    for (SurfaceGroup& group : mesh.groups)
        group.number = fits ? static_cast<int32_t>(++above) : free_of_volumes.next();
}

}  // namespace cleft::io
