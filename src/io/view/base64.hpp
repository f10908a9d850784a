// Bytes as text of 64 letters (RFC 4648), which may stand in a page.
#pragma once

#include <string>
#include <string_view>

namespace cleft::io
{

std::string to_base64(std::string_view bytes);

}  // namespace cleft::io
