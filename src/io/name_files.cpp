// Entries: names of labels from tables.
#include "cleft/cleft_io.h"
#include "io/create_volume.hpp"
#include "io/entry.hpp"
#include "io/name_table.hpp"

#include <functional>

namespace cleft::io
{

namespace
{

// What has labels, a volume or a mesh.
struct Named {
    std::string what;
    const int32_t* labels;
    int64_t count;
    std::function<std::string(int32_t)> name_of;
    std::function<cleft_status(int32_t, const char*)> set_name;
};

std::string note_of_change(int32_t label, const std::string& name, const std::string& what, const std::string& before)
{
    return "it calls label " + std::to_string(label) + " '" + name + "', and " + what + " '" + before + "'";
}

void use_names(const NameTable& table, const Named& named, std::vector<std::string>& notes)
{
    int64_t used = 0;
    int64_t changed = 0;
    std::string first_change;
    for (int64_t i = 0; i < named.count; ++i) {
        const int32_t label = named.labels[i];
        const auto found = table.names.find(label);
        if (found == table.names.end() || found->second.empty())
            continue;
        ++used;
        const std::string& name = found->second;
        const std::string before = named.name_of(label);
        if (!before.empty() && before != name && changed++ == 0)
            first_change = note_of_change(label, name, named.what, before);
        if (const cleft_status status = named.set_name(label, name.c_str()))
            throw Error(status, "a label cannot be called '" + name + "'");
    }
    if (used == 0)
        notes.push_back("it has no name for any label of " + named.what);
    if (changed > 1)
        first_change += "; so it is with " + std::to_string(changed) + " labels";
    if (changed > 0)
        notes.push_back(first_change + "; the names of the table are taken");
}

void read_names(cleft_context* context, const char* path, const Named& named)
{
    const NameTable table = read_name_table(required(path, "path"));
    const std::string place = "'" + std::string(path) + "': ";
    std::vector<std::string> notes = table.notes;
    use_names(table, named, notes);
    for (const std::string& note : notes)
        report(context, place + note);
}

}  // namespace

}  // namespace cleft::io

using namespace cleft::io;

cleft_status cleft_io_read_volume_names(cleft_context* context, const char* path, cleft_volume* volume) noexcept
{
    return entry(context, {volume}, [&] {
        required(volume, "volume");
        read_names(context, path,
                   {"the volume", cleft_volume_labels(volume), cleft_volume_label_count(volume),
                    [=](int32_t label) { return cleft_volume_label_name(volume, label); },
                    [=](int32_t label, const char* name) { return cleft_volume_set_label_name(volume, label, name); }});
    });
}

cleft_status cleft_io_read_mesh_names(cleft_context* context, const char* path, cleft_mesh* mesh) noexcept
{
    return entry(context, {mesh}, [&] {
        required(mesh, "mesh");
        read_names(context, path,
                   {"the mesh", cleft_mesh_labels(mesh), cleft_mesh_label_count(mesh),
                    [=](int32_t label) { return cleft_mesh_label_name(mesh, label); },
                    [=](int32_t label, const char* name) { return cleft_mesh_set_label_name(mesh, label, name); }});
    });
}
