// Makes what labels are called in files of their numbers and names, and reads it back.
#include "io/label_names.hpp"

#include <charconv>

namespace cleft::io
{

namespace
{

constexpr const char* kMaterialPrefix = "material_";
constexpr const char* kMinusWord = "minus";
constexpr size_t kLongestName = 40;  // CalculiX ends names of sets after 80 characters

// Letters and digits of ASCII. Blanks, commas and accents break names in some solvers, and
// std::isalnum() follows the locale.
bool is_plain(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

// One underscore in the place of all other characters between letters and digits.
std::string plain(const std::string& name)
{
    std::string text;
    bool gap = false;
    for (const char c : name) {
        // What is beyond the limit is dropped. The number in front keeps names apart that are then
        // alike.
        if (is_plain(c) && text.size() + (gap ? 1 : 0) < kLongestName) {
            if (gap && !text.empty())
                text += '_';
            text += c;
        }
        gap = !is_plain(c);
    }
    return text;
}

}  // namespace

std::string word_of(int32_t label)
{
    // A minus sign is an operator in the scripts of Gmsh and FreeFEM. int64: -(-2^31) does not fit
    // 32 bits.
    return label < 0 ? kMinusWord + std::to_string(-int64_t{label}) : std::to_string(label);
}

std::string material_name(int32_t label, const std::string& name)
{
    const std::string behind = plain(name);
    return kMaterialPrefix + word_of(label) + (behind.empty() ? "" : "_" + behind);
}

std::string material_title(int32_t label, const std::string& name) { return material_name(label) + " " + name; }

std::string surface_name(int32_t side, int32_t first, int32_t second)
{
    // In the order of CLEFT_SIDE_X_MIN to CLEFT_SIDE_OTHER.
    static const char* const sides[] = {"box_x_min_", "box_x_max_", "box_y_min_", "box_y_max_",
                                        "box_z_min_", "box_z_max_", "hull_"};
    return side < 0 ? "interface_" + word_of(first) + "_" + word_of(second) : sides[side] + word_of(first);
}

bool label_of_material_name(const std::string& text, int32_t& label, std::string& name)
{
    const std::string prefix = kMaterialPrefix;
    const std::string minus = kMinusWord;
    // Another program's names are no labels.
    if (text.compare(0, prefix.size(), prefix) != 0)
        return false;
    std::string number = text.substr(prefix.size());
    if (number.compare(0, minus.size(), minus) == 0)
        number.replace(0, minus.size(), "-");
    const char* end_of_text = number.data() + number.size();
    const auto [end, error] = std::from_chars(number.data(), end_of_text, label);
    // Behind the number only a name may follow: "material_3x" was not made by this library.
    if (error != std::errc() || (end != end_of_text && *end != '_' && *end != ' '))
        return false;
    name = end == end_of_text ? "" : std::string(end + 1, end_of_text);
    return true;
}

}  // namespace cleft::io
