// What a label is called in files: "material_3", or "material_3_right_lung" if the label has a name.
#pragma once

#include <cstdint>
#include <string>

namespace cleft::io
{

// The number of a label as part of a name: "3", "minus7".
std::string word_of(int32_t label);

// "material_3", "material_minus7", "material_3_right_lung": letters, digits and underscores, which every format takes.
// No two labels get the same one, as the number stands before the name.
std::string material_name(int32_t label, const std::string& name = "");
// As above, but with the name as it is: "material_3 right lung".
// For formats that keep any text, such as VTK's field data.
std::string material_title(int32_t label, const std::string& name);

// "interface_1_3", "box_x_min_3", "hull_3": triangles between two labels, or in a side of the box (CLEFT_SIDE_..., and
// -1 for interfaces).
std::string surface_name(int32_t side, int32_t first, int32_t second);

// The label in one of these, and the name behind it ("" if there is none).
bool label_of_material_name(const std::string& text, int32_t& label, std::string& name);

}  // namespace cleft::io
