// Names of labels: checked where they come in, and handed on with the labels that they belong to.
#include "capi/label_names.hpp"

#include "base/error.hpp"
#include "base/utf8.hpp"

#include <algorithm>
#include <string_view>

namespace cleft::capi
{

namespace
{

void check_name(std::string_view name, int32_t label)
{
    const std::string whose = "the name of label " + std::to_string(label);
    while (!name.empty()) {
        const Character next = first_character(name);
        // Names go into files and messages as they are; most formats say UTF-8, and readers refuse what is not.
        if (next.bytes == 0)
            throw Error(CLEFT_ERROR_ARGUMENT, whose + " is not UTF-8");
        // A line break would end the record of a text format, and the rest be read as data.
        if (next.is_control())
            throw Error(CLEFT_ERROR_ARGUMENT, whose + " has a line break or another control character in it");
        name.remove_prefix(next.bytes);
    }
}

}  // namespace

void set_label_name(LabelNames& names, const Array<int32_t>& labels, int32_t label, const char* name, const char* owner)
{
    // An error, not ignored: a caller that names a label which is not there has another label map in mind.
    if (std::find(labels.begin(), labels.end(), label) == labels.end())
        throw Error(CLEFT_ERROR_ARGUMENT, std::string(owner) + " has no label " + std::to_string(label));
    if (!name || *name == '\0') {
        names.erase(label);
        return;
    }
    check_name(name, label);
    names[label] = name;
}

const char* label_name(const LabelNames& names, int32_t label)
{
    const auto found = names.find(label);
    return found == names.end() ? "" : found->second.c_str();
}

void add_label_names(LabelNames& names, const LabelNames& more, const Array<int32_t>& labels)
{
    for (const auto& row : more)
        if (std::binary_search(labels.begin(), labels.end(), row.first))
            names.insert(row);
}

}  // namespace cleft::capi
