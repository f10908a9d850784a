// Finds the tags of an XML file, and writes and reads the characters that XML keeps for itself.
#include "io/xml_scanner.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cleft::io
{

namespace
{

// The five entities that XML 1.0, section 4.6 defines.
constexpr std::pair<char, std::string_view> kEntities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}};

constexpr const char* kXmlBlanks = " \t\r\n";

// name="value" or name='value', any number of them.
std::map<std::string, std::string> parse_attributes(std::string_view text)
{
    std::map<std::string, std::string> attributes;
    for (size_t at = 0;;) {
        at = text.find_first_not_of(kXmlBlanks, at);
        const size_t equals = text.find('=', at);
        // A damaged attribute ends the list. What is missing is then refused by who asks for it.
        if (at == std::string_view::npos || equals == std::string_view::npos)
            return attributes;
        const size_t open = text.find_first_of("\"'", equals);
        const size_t close = open == std::string_view::npos ? open : text.find(text[open], open + 1);
        if (close == std::string_view::npos)
            return attributes;
        std::string name(text.substr(at, equals - at));
        name.erase(name.find_last_not_of(kXmlBlanks) + 1);
        attributes[name] = from_xml(text.substr(open + 1, close - open - 1));
        at = close + 1;
    }
}

}  // namespace

std::string to_xml(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        const auto* entity =
            std::find_if(std::begin(kEntities), std::end(kEntities), [c](const auto& e) { return e.first == c; });
        if (entity != std::end(kEntities))
            out += entity->second;
        else
            out += c;
    }
    return out;
}

std::string from_xml(std::string_view text)
{
    std::string out;
    while (!text.empty()) {
        const auto* entity = std::find_if(std::begin(kEntities), std::end(kEntities), [text](const auto& e) {
            return text.substr(0, e.second.size()) == e.second;
        });
        // Numeric entities stay as they are: VTK's writers hardly use them.
        const bool found = entity != std::end(kEntities);
        out += found ? entity->first : text.front();
        text.remove_prefix(found ? entity->second.size() : 1);
    }
    return out;
}

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
        // A comment may have ">" in it.
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
        // The text may be the base64 of an array. It is a view, so that nothing is copied before an
        // array is asked for.
        tag.text = text_.substr(at_, text_.find('<', at_) - at_);
        return true;
    }
}

}  // namespace cleft::io
