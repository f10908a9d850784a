// Tables of the names of labels, as programs of segmentation keep them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cleft::io
{

struct NameTable {
    std::map<int32_t, std::string> names;
    std::vector<std::string> notes;  // what is uncertain, a sentence each
};

// Reads one of five forms:
// - a label and its name a line, with blanks, a tab, a comma or "=" between them;
// - MRIcron's: label, name without blanks, and a number;
// - FreeSurfer's colour table: label, name without blanks, and four numbers;
// - ITK-SNAP's label descriptions: label, six numbers, and the name in quotes;
// - that of BIDS: columns with tabs between them under the headings "index", "name" and others.
// Lines that begin with "#" and blank lines are passed over. Throws Error with the file and the line.
NameTable read_name_table(const std::string& path);

}  // namespace cleft::io
