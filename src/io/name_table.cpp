// Reads a table of names. A first line with headings is that of BIDS. Else the form is told by all lines together: a
// name in quotes at the end is ITK-SNAP's, four numbers behind a word are FreeSurfer's, and one is MRIcron's, if the
// words alone are different names. Of the first two, some lines may be odd; each is told.
#include "io/name_table.hpp"

#include "base/utf8.hpp"
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

// A line with something to read in it.
struct Line {
    size_t number = 0;  // from 1 on
    std::string text;   // without blanks at its ends
};

struct Row {
    size_t line = 0;
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

// "255 0 0 0.5 1 1" and a name in quotes.
bool has_snap_numbers(const Row& row)
{
    constexpr size_t kNumbers = 6;
    if (!is_quoted(row))
        return false;
    const std::vector<std::string> words = words_of(row.rest.substr(0, row.rest.find('"')));
    const auto is_real = [](const std::string& word) {
        double number = 0;
        const char* end = word.data() + word.size();
        return std::from_chars(word.data(), end, number).ptr == end;
    };
    return words.size() == kNumbers && std::all_of(words.begin(), words.end(), is_real);
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

std::vector<Line> read_lines(const std::string& path)
{
    std::string text = read_whole_file(path);
    constexpr std::string_view kMark = "\xEF\xBB\xBF";  // of UTF-8, which editors of Windows put in front
    if (text.compare(0, kMark.size(), kMark) == 0)
        text.erase(0, kMark.size());
    std::istringstream all(text);
    std::vector<Line> lines;
    size_t number = 0;
    for (std::string line; std::getline(all, line);) {
        ++number;
        const std::string_view content = trimmed(line);
        if (!content.empty() && content.front() != '#')
            lines.push_back({number, std::string(content)});
    }
    if (lines.empty())
        throw Error(CLEFT_ERROR_FORMAT, "'" + path + "': there are no labels in it");
    return lines;
}

Row row_of(const std::string& path, const Line& line)
{
    Row row{line.number, 0, ""};
    const char* end = line.text.data() + line.text.size();
    const auto read = std::from_chars(line.text.data(), end, row.label);
    const std::string_view behind(read.ptr, static_cast<size_t>(end - read.ptr));
    if (read.ec != std::errc() || (!behind.empty() && std::string_view(" \t,;=").find(behind[0]) == std::string::npos))
        fail(path, line.number, "it begins with no label, which is a whole number");
    row.rest = checked_rest(path, line.number, behind);
    return row;
}

std::vector<std::string_view> cells_of(std::string_view text)
{
    std::vector<std::string_view> cells;
    for (size_t tab = text.find('\t'); tab != std::string_view::npos; tab = text.find('\t')) {
        cells.push_back(trimmed(text.substr(0, tab)));
        text.remove_prefix(tab + 1);
    }
    cells.push_back(trimmed(text));
    return cells;
}

// Columns under headings, with tabs between them, as in BIDS: "index", "name" and others. Nothing if the first line is
// none of headings.
bool read_columns(const std::string& path, const std::vector<Line>& lines, std::vector<Row>& rows)
{
    const std::vector<std::string_view> headings = cells_of(lines.front().text);
    const auto column_of = [&](std::string_view heading) {
        return static_cast<size_t>(std::find(headings.begin(), headings.end(), heading) - headings.begin());
    };
    const size_t index = column_of("index"), name = column_of("name");
    if (index == headings.size() || name == headings.size())
        return false;
    for (auto line = lines.begin() + 1; line != lines.end(); ++line) {
        const std::vector<std::string_view> cells = cells_of(line->text);
        if (cells.size() <= std::max(index, name))
            fail(path, line->number, "it has fewer columns than the headings");
        Row row = row_of(path, {line->number, std::string(cells[index])});
        row.rest = cells[name] == "n/a" ? "" : checked_rest(path, line->number, cells[name]);
        rows.push_back(row);
    }
    return true;
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

// The form of a table whose lines are not just labels and names.
struct Form {
    bool (*is_row)(const Row&);
    std::string (*name_of)(const Row&);
    const char* what;
};

constexpr Form kNameForms[] = {
    {has_snap_numbers, [](const Row& row) { return name_in_quotes(row.rest); },
     "six numbers and a name in quotes, as the lines of ITK-SNAP"},
    {[](const Row& row) { return has_numbers(row, 4); }, [](const Row& row) { return words_of(row.rest).front(); },
     "a name without blanks and four numbers, as the lines of FreeSurfer"},
};

// Null: the lines are names alone, or a table of MRIcron.
const Form* form_of(const std::vector<Row>& rows)
{
    for (const Form& form : kNameForms)
        // A name may look like a line of a form; more names are no chance.
        if (2 * static_cast<size_t>(std::count_if(rows.begin(), rows.end(), form.is_row)) >= rows.size())
            return &form;
    return nullptr;
}

// Lines of another form are told. What they have behind the label is taken for the name.
void add_names(const Form& form, const std::vector<Row>& rows, NameTable& table)
{
    size_t odd = 0;
    std::string first;
    for (const Row& row : rows) {
        const std::string name = form.is_row(row) ? form.name_of(row) : plain_name(row.rest);
        add_name(row.label, name, table);
        if (!form.is_row(row) && odd++ == 0)
            first = "line " + std::to_string(row.line) + " is not " + form.what + " around it, so label " +
                    std::to_string(row.label) + " is called '" + name + "'";
    }
    if (odd > 1)
        first += "; so it is with " + std::to_string(odd) + " lines";
    if (odd > 0)
        table.notes.push_back(first);
}

}  // namespace

NameTable read_name_table(const std::string& path)
{
    const std::vector<Line> lines = read_lines(path);
    std::vector<Row> rows;
    NameTable table;
    if (read_columns(path, lines, rows)) {
        for (const Row& row : rows)
            add_name(row.label, row.rest, table);
        return table;
    }
    for (const Line& line : lines)
        rows.push_back(row_of(path, line));
    if (const Form* form = form_of(rows)) {
        add_names(*form, rows, table);
        return table;
    }
    const bool first_word = is_table(rows, 1);
    const bool snap = std::all_of(rows.begin(), rows.end(), is_quoted);
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
