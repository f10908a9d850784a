// What the lists STRIP and ONLY keep, and the sentences on lists that cannot be meant.
#include "capi/kept_labels.hpp"

#include "capi/mesh_frame.hpp"
#include "mesh/strip.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace cleft::capi
{

namespace
{

bool contains(const Array<UserLabel>& list, UserLabel label)
{
    return std::find(list.begin(), list.end(), label) != list.end();
}

// "label 3", "labels 3 and 5", "labels 3, 5, 8 and 4 more".
std::string named(Array<UserLabel> labels)
{
    // Atlases have hundreds of labels, and a sentence that names them all is not read.
    constexpr size_t kMost = 5;
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    const size_t more = labels.size() > kMost ? labels.size() - kMost : 0;
    const size_t shown = labels.size() - more;
    std::string text = labels.size() == 1 ? "label " : "labels ";
    for (size_t i = 0; i < shown; ++i) {
        const bool is_last = i + 1 == shown && more == 0;
        text += (i == 0 ? "" : is_last ? " and " : ", ") + std::to_string(number_of(labels[i]));
    }
    return more > 0 ? text + " and " + std::to_string(more) + " more" : text;
}

std::string list_names(const cleft_options& options)
{
    return options.only.empty() ? "strip" : options.strip.empty() ? "only" : "strip and only";
}

}  // namespace

Array<UserLabel> user_labels(const int32_t* numbers, int64_t count)
{
    Array<UserLabel> labels(count);
    std::transform(numbers, numbers + count, labels.begin(), [](int32_t number) { return UserLabel{number}; });
    return labels;
}

KeptMaterials kept_labels(const Array<UserLabel>& labels, const cleft_options* options, const char* whose)
{
    if (!options || (options->strip.empty() && options->only.empty()))
        return {};
    Array<char> is_kept;
    for (const UserLabel label : labels) {
        const bool is_asked_for = options->only.empty() || contains(options->only, label);
        is_kept.push_back(is_asked_for && !contains(options->strip, label) ? 1 : 0);
    }
    const bool keeps_some = std::find(is_kept.begin(), is_kept.end(), 1) != is_kept.end();
    // An empty mesh would look like success, and fail in the program that reads it.
    if (!keeps_some && !is_kept.empty())
        throw Error(CLEFT_ERROR_OPTION,
                    list_names(*options) + " would leave nothing of the " + whose + ", which has " + named(labels));
    return KeptMaterials(std::move(is_kept));
}

void warn_of_unknown_labels(const Array<UserLabel>& labels, const cleft_options* options, const char* whose,
                            const Run& run)
{
    if (!options)
        return;
    const auto warn = [&](const char* option, const Array<UserLabel>& list) {
        Array<UserLabel> unknown;
        for (const UserLabel label : list)
            if (!contains(labels, label))
                unknown.push_back(label);
        // No error: a caller often has one list for many volumes. But a misspelt number would otherwise leave a label
        // in unnoticed.
        if (!unknown.empty())
            run.warn(std::string(option) + " names " + named(unknown) + ", which the " + whose + " does not have");
    };
    warn("strip", options->strip);
    warn("only", options->only);
}

void strip_labels(cleft_mesh& mesh, const cleft_options* options)
{
    const KeptMaterials kept = kept_labels(user_labels(mesh.labels.data(), mesh.labels.count()), options, "mesh");
    if (kept.all())
        return;
    const auto is_kept = [&](int32_t label) {
        const auto place = std::lower_bound(mesh.labels.begin(), mesh.labels.end(), label) - mesh.labels.begin();
        return kept.has(static_cast<Material>(place));
    };
    strip(mesh.mesh.points, mesh.mesh.tets, mesh.mesh.labels, is_kept);
    mesh.labels = distinct_labels(mesh.mesh.labels, Run());
    // Names of labels that are gone would come back if the mesh were written.
    const LabelNames all = std::exchange(mesh.names, {});
    add_label_names(mesh.names, all, mesh.labels);
}

}  // namespace cleft::capi
