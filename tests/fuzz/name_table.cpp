// Tables of names of labels, on a mesh that has names already.
#include "cleft/cleft_io.h"

#include "fuzz/given_files.hpp"
#include "fuzz/judge.hpp"

#include <map>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

using fuzz::expect;
using Names = std::map<int32_t, std::string>;

// A fan of tetrahedra around an edge, each with a label of its own, which the inputs of the corpus name.
cleft_mesh* small_mesh(const fuzz::Context& context)
{
    const double points[] = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0};
    const int32_t tets[] = {0, 1, 2, 3, 0, 1, 3, 4, 0, 1, 4, 5, 0, 1, 5, 2};
    const int32_t labels[] = {0, 3, -7, 2147483647};
    cleft_mesh* mesh = nullptr;
    expect(cleft_mesh_create(context, 6, points, 4, tets, labels, 0, &mesh) == CLEFT_OK, "a mesh cannot be made");
    expect(cleft_mesh_set_label_name(mesh, 3, "right lung") == CLEFT_OK, "a label cannot be named");
    return mesh;
}

Names names_of(const cleft_mesh* mesh)
{
    Names names;
    for (int64_t i = 0; i < cleft_mesh_label_count(mesh); ++i) {
        const int32_t label = cleft_mesh_labels(mesh)[i];
        names[label] = cleft_mesh_label_name(mesh, label);
        expect(fuzz::is_line(names[label]), "the name of a label is no line of text");
    }
    return names;
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const fuzz::Context context;
    const std::string path = fuzz::give_files(data, size, "given.txt") + "given.txt";
    cleft_mesh* mesh = small_mesh(context);
    const Names before = names_of(mesh);
    if (context.succeeded(cleft_io_read_mesh_names(context, path.c_str(), mesh))) {
        const Names once = names_of(mesh);
        expect(!once.at(3).empty(), "a name was taken away");
        expect(context.succeeded(cleft_io_read_mesh_names(context, path.c_str(), mesh)), "a table is refused later");
        expect(names_of(mesh) == once, "a table gives other names later");
    } else {
        expect(names_of(mesh) == before, "a table that is refused gives names");
    }
    cleft_mesh_destroy(mesh);
    return 0;
}
