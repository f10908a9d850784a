#include "io/xml_scanner.hpp"

namespace cleft::io
{

namespace
{

constexpr const char* blanks = " \t\r\n";

// name="value" or name='value', any number of them.
std::map<std::string, std::string> parse_attributes(std::string_view text)
{
    std::map<std::string, std::string> attributes;
    for (size_t at = 0;;) {
        at = text.find_first_not_of(blanks, at);
        const size_t equals = text.find('=', at);
        if (at == std::string_view::npos || equals == std::string_view::npos)
            return attributes;
        const size_t open = text.find_first_of("\"'", equals);
        const size_t close = open == std::string_view::npos ? open : text.find(text[open], open + 1);
        if (close == std::string_view::npos)
            return attributes;
        std::string name(text.substr(at, equals - at));
        name.erase(name.find_last_not_of(blanks) + 1);
        attributes[name] = text.substr(open + 1, close - open - 1);
        at = close + 1;
    }
}

}  // namespace

std::string XmlTag::get(const std::string& attribute) const
{
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? "" : found->second;
}

bool XmlScanner::next(XmlTag& tag)
{
    for (;;) {
        const size_t open = text_.find('<', at_);
        if (open == std::string_view::npos)
            return false;
        const bool comment = text_.compare(open, 4, "<!--") == 0;
        const size_t close = comment ? text_.find("-->", open) : text_.find('>', open);
        if (close == std::string_view::npos)
            return false;
        at_ = close + (comment ? 3 : 1);
        if (comment || text_[open + 1] == '?' || text_[open + 1] == '!')
            continue;
        const std::string_view inside = text_.substr(open + 1, close - open - 1);
        const size_t name_end = std::min(inside.find_first_of(" \t\r\n", 1), inside.size());
        tag.name = inside.substr(0, name_end);
        tag.attributes = parse_attributes(inside.substr(name_end));
        tag.end = at_;
        tag.text = text_.substr(at_, text_.find('<', at_) - at_);
        return true;
    }
}

}  // namespace cleft::io
