// Names of labels: checked where they come in, and handed on with the labels that they belong to.
#include "capi/label_names.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <string_view>

namespace cleft::capi
{

namespace
{

struct Sequence {
    uint32_t code = 0;  // the character
    size_t bytes = 0;   // 0: not UTF-8
};

// The character at the start of a text: not too long a form, no surrogate, nothing beyond Unicode.
Sequence first_character(std::string_view text)
{
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return {lead, 1};
    const size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    static constexpr uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes)
        return {};
    uint32_t code = lead & (0x7FU >> bytes);
    for (size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80)
            return {};
        code = code << 6 | (byte(i) & 0x3FU);
    }
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < kLeast[bytes] || surrogate || code > 0x10FFFF ? Sequence{} : Sequence{code, bytes};
}

void check_name(std::string_view name, int32_t label)
{
    const std::string whose = "the name of label " + std::to_string(label);
    while (!name.empty()) {
        const Sequence next = first_character(name);
        if (next.bytes == 0)
            throw Error(CLEFT_ERROR_ARGUMENT, whose + " is not UTF-8");
        if (next.code < 0x20 || (next.code >= 0x7F && next.code < 0xA0))
            throw Error(CLEFT_ERROR_ARGUMENT, whose + " has a line break or another control character in it");
        name.remove_prefix(next.bytes);
    }
}

}  // namespace

void set_label_name(LabelNames& names, const std::vector<int32_t>& labels, int32_t label, const char* name,
                    const char* owner)
{
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

void add_label_names(LabelNames& names, const LabelNames& more, const std::vector<int32_t>& labels)
{
    for (const auto& row : more)
        if (std::binary_search(labels.begin(), labels.end(), row.first))
            names.insert(row);
}

}  // namespace cleft::capi
