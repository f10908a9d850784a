// Names of files: extensions, and what they say.
#pragma once

#include <string>

namespace cleft::io
{

// ".msh", ".nii.gz": lower case, with the dot; "" if there is none. Of ".gz" the extension before it is a part.
std::string extension_of(const std::string& path);
// The path without .node, .ele or .face.
std::string tetgen_prefix(const std::string& path);

}  // namespace cleft::io
