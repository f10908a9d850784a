// As much of XML as VTK's files need: the tags in their order, with their attributes.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace cleft::io
{

// Text as the value of an attribute, and back: &, <, >, " and ' have names.
std::string to_xml(std::string_view text);
std::string from_xml(std::string_view text);

struct XmlTag {
    std::string name;                               // "/Points" for an end
    std::map<std::string, std::string> attributes;  // characters with names in place of these
    std::string_view text;                          // up to the next '<'
    size_t end = 0;                                 // place behind the '>'

    // The attribute, or "".
    std::string get(const std::string& attribute) const;
};

// It knows no nesting and no sections of CDATA, which VTK's and OME's files do not use. `text` must
// outlive it and its tags.
class XmlScanner
{
public:
    explicit XmlScanner(std::string_view text) : text_(text) {}
    // The next tag that is no comment or declaration; false at the end or where the file is damaged.
    bool next(XmlTag& tag);

private:
    std::string_view text_;
    size_t at_ = 0;
};

}  // namespace cleft::io
