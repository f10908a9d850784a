// What has a name in an HDF5 file: the members of a group, and the attributes of an object.
#pragma once

#include "io/hdf5_file.hpp"

#include <map>
#include <string>

namespace cleft::io
{

// The objects that a group has, by name. Links to other files and by path are left out.
std::map<std::string, uint64_t> hdf5_members(const Hdf5File& file, uint64_t group);

// An attribute that is a text of fixed length, and one that is a list of whole numbers. Throws an Error that names the
// attribute if it is missing or something else.
std::string hdf5_text_attribute(const Hdf5File& file, uint64_t object, const std::string& name);
std::vector<int64_t> hdf5_integer_attribute(const Hdf5File& file, uint64_t object, const std::string& name);

}  // namespace cleft::io
