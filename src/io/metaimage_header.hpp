// The header of a MetaImage file: lines of "Key = Value", of which ElementDataFile is the last.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace cleft::io
{

using MetaFields = std::map<std::string, std::string>;

struct MetaHeader {
    MetaFields fields;
    std::vector<std::string> list;  // the lines behind "ElementDataFile = LIST"
    uintmax_t end = 0;
};

// Throws Errors that do not name the file.
MetaHeader read_meta_header(const std::string& path);

// Is this value of ElementDataFile followed by names of files, one a line?
bool is_meta_list(const std::string& value);

bool meta_truth_of(const MetaFields& fields, const std::string& key, bool otherwise);

// The first of these fields that is there, or null. They are names of one thing, so two that differ are refused.
const MetaFields::value_type* one_meta_field(const MetaFields& fields, std::initializer_list<const char*> keys);

// Names the fields that neither this reader nor MetaIO knows, as they may be misspelt.
void note_unknown_fields(const MetaFields& fields, std::vector<std::string>& notes);

}  // namespace cleft::io
