// What a user calls a material: any number of 32 bits.
#pragma once

#include <cstdint>
#include <string>

namespace cleft
{

// A type of its own, so that it is no index and no Material by mistake: neither converts into the other, and no array
// is indexed by it. The C interface makes it of the numbers of a caller, and these of it.
enum class UserLabel : int32_t {};

constexpr int32_t number_of(UserLabel label) { return static_cast<int32_t>(label); }

// "label 3"
inline std::string name_of(UserLabel label) { return "label " + std::to_string(number_of(label)); }

}  // namespace cleft
