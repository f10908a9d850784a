// Reads a table of names. The form is told by all lines together: a name in quotes at the end is ITK-SNAP's, four
// numbers behind a word are FreeSurfer's, and one is MRIcron's, if the words alone are different names.
#include "io/name_table.hpp"

#include "io/header_values.hpp"
#include "io/text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>
#include <vector>

namespace cleft::io
{

namespace
{

struct Row {
    int32_t label = 0;
    std::string rest;  // without blanks at its ends
};

bool is_number(const std::string& word)
{
    int64_t number = 0;
    const char* end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, number);
    return read.ec == std::errc() && read.ptr == end;
}

bool is_quoted(const Row& row)
{
    return !row.rest.empty() && row.rest.back() == '"' && row.rest.find('"') + 1 < row.rest.size();
}

// "Left-Thalamus 0 118 14 0"
bool has_numbers(const Row& row, size_t count)
{
    const std::vector<std::string> words = words_of(row.rest);
    return words.size() == 1 + count && !is_number(words[0]) && std::all_of(words.begin() + 1, words.end(), is_number);
}

// Is each line a word and so many numbers? "Area 17" and "Area 18" are names with numbers, as the word is one.
bool is_table(const std::vector<Row>& rows, size_t numbers)
{
    std::set<std::string> words;
    for (const Row& row : rows)
        if (!has_numbers(row, numbers) || !words.insert(words_of(row.rest).front()).second)
            return false;
    return rows.size() > 1;
}

std::string name_in_quotes(const std::string& text)
{
    const size_t first = text.find('"');
    return text.substr(first + 1, text.size() - first - 2);
}

// "3, right lung" and "3=right lung"; quotes around a name do not belong to it.
std::string plain_name(const std::string& text)
{
    std::string name = text;
    if (!name.empty() && (name.front() == ',' || name.front() == '=' || name.front() == ';'))
        name = std::string(trimmed(std::string_view(name).substr(1)));
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
    return name;
}

[[noreturn]] void fail(const std::string& path, size_t line, const std::string& what)
{
    throw Error(CLEFT_ERROR_FORMAT, "'" + path + "', line " + std::to_string(line) + ": " + what);
}

// What is behind a label: its name, with numbers in some forms. Tabs stand for blanks.
std::string checked_rest(const std::string& path, size_t number, std::string_view behind)
{
    std::string rest(trimmed(behind));
    std::replace(rest.begin(), rest.end(), '\t', ' ');
    for (std::string_view left = rest; !left.empty();) {
        const Character next = first_character(left);
        if (next.bytes == 0)
            fail(path, number, "the name is not UTF-8");
        if (next.is_control())
            fail(path, number, "the name has a control character in it");
        left.remove_prefix(next.bytes);
    }
    return rest;
}

// One line, or nothing of it.
bool read_row(const std::string& path, size_t number, std::string_view line, Row& row)
{
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#')
        return false;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, row.label);
    const std::string_view behind(read.ptr, static_cast<size_t>(end - read.ptr));
    if (read.ec != std::errc() || (!behind.empty() && std::string_view(" \t,;=").find(behind[0]) == std::string::npos))
        fail(path, number, "it begins with no label, which is a whole number");
    row.rest = checked_rest(path, number, behind);
    return true;
}

std::vector<Row> read_rows(const std::string& path)
{
    std::string text = read_whole_file(path);
    constexpr std::string_view kMark = "\xEF\xBB\xBF";  // of UTF-8, which editors of Windows put in front
    if (text.compare(0, kMark.size(), kMark) == 0)
        text.erase(0, kMark.size());
    std::istringstream lines(text);
    std::vector<Row> rows;
    size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        Row row;
        if (read_row(path, ++number, line, row))
            rows.push_back(row);
    }
    if (rows.empty())
        throw Error(CLEFT_ERROR_FORMAT, "'" + path + "': there are no labels in it");
    return rows;
}

// A few words that are all followed by a number may also be names that end with one: "Left 5", "Right 6".
void note_doubt(const std::vector<Row>& rows, NameTable& table)
{
    constexpr size_t kFew = 5;
    if (rows.size() < kFew && is_table(rows, 1))
        table.notes.push_back(
            "the numbers behind the names are taken for no parts of them, as in tables of MRIcron: '" +
            rows.front().rest + "' is '" + words_of(rows.front().rest).front() + "'");
}

// The last line of a label holds.
void add_name(int32_t label, const std::string& name, NameTable& table)
{
    std::string& place = table.names[label];
    if (!place.empty() && place != name)
        table.notes.push_back("label " + std::to_string(label) + " is called '" + place + "' and then '" + name +
                              "', which is taken");
    place = name;
}

}  // namespace

NameTable read_name_table(const std::string& path)
{
    const std::vector<Row> rows = read_rows(path);
    const bool snap = std::all_of(rows.begin(), rows.end(), is_quoted);
    const bool first_word = is_table(rows, 4) || is_table(rows, 1);
    NameTable table;
    if (!snap)
        note_doubt(rows, table);
    for (const Row& row : rows)
        add_name(row.label,
                 snap         ? name_in_quotes(row.rest)
                 : first_word ? words_of(row.rest).front()
                              : plain_name(row.rest),
                 table);
    return table;
}

}  // namespace cleft::io
