// The arrays of VTK's XML files: inline or appended, as text, base64 or raw, compressed by zlib or not.
#pragma once

#include "io/xml_scanner.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cleft::io
{

// What holds for all arrays of a file.
struct VtkEncoding {
    bool compressed = false;
    bool wide_headers = true;      // uint64, or else uint32
    bool appended_base64 = false;  // or else raw
    std::string_view appended;     // what follows the '_' of <AppendedData>
};

// As the tag <VTKFile> says, and where <AppendedData> begin. Errors do not name the file.
VtkEncoding vtk_encoding_of(const XmlTag& file);
void find_vtk_appended_data(std::string_view text, const XmlTag& tag, VtkEncoding& encoding);

// The `count` numbers (fewer or more are an error) of a <DataArray>. Errors do not name the file.
std::vector<double> read_vtk_reals(const XmlTag& array, const VtkEncoding& encoding, int64_t count);
std::vector<int64_t> read_vtk_integers(const XmlTag& array, const VtkEncoding& encoding, int64_t count);

}  // namespace cleft::io
