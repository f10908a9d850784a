// Whether two paths are one file.
#include "output_conflicts.hpp"

#include "exit_code.hpp"
#include "output_files.hpp"
#include "staged_outputs.hpp"

#include <fnmatch.h>
#include <sys/stat.h>

#include <cctype>
#include <fstream>

namespace cleft_cli
{
namespace
{

namespace fs = std::filesystem;

// Nothing is written after it, nor a report of it: that may be what is in the way.
// A report would be written to the very path that is refused.
Failure refused(const std::string& sentence)
{
    Failure failure = usage_failure(sentence);
    failure.is_reported = false;
    return failure;
}

struct Place {
    std::string path;
    std::string output;  // as the user says it; `path` may be of another file of it
    fs::path target;     // links followed
    bool exists = false;
    struct stat file = {};
    struct stat folder = {};
};

Place place_of(const std::string& path, const std::string& output)
{
    Place place;
    place.path = path;
    place.output = output;
    place.target = link_target(path);
    // By device and inode below: two paths may be one file through links, "..", mounts or hard
    // links.
    place.exists = stat(place.target.c_str(), &place.file) == 0;
    // A folder that does not exist leaves zeros. checked_mesh_output() refuses it later, in words
    // of its own.
    (void)stat(folder_of(place.target).c_str(), &place.folder);
    return place;
}

bool same(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

// One name in one folder.
bool same_place(const Place& a, const Place& b)
{
    return same(a.folder, b.folder) && a.target.filename() == b.target.filename();
}

bool same_file(const Place& a, const Place& b)
{
    return a.exists && b.exists ? same(a.file, b.file) : same_place(a, b);
}

// A pattern of slices as one of the shell: "%03d" matches whatever stands for it.
// fnmatch() answers whether the output is one of the slices, without listing the folder.
std::string shell_pattern(const std::string& name)
{
    std::string pattern;
    for (std::size_t i = 0; i < name.size(); ++i) {
        std::size_t end = i + 1;
        while (name[i] == '%' && end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) != 0)
            ++end;
        const bool is_number = name[i] == '%' && end < name.size() && name[end] == 'd';
        if (is_number)
            i = end;
        // The readers take only "*" and "?" as wildcards; fnmatch() knows more.
        else if (name[i] == '[' || name[i] == '\\')
            pattern += '\\';
        pattern += is_number ? '*' : name[i];
    }
    return pattern;
}

bool is_input(const Place& output, const std::string& input)
{
    for (const std::string& file : files_of(input))
        if (same_file(output, place_of(file, input)))
            return true;
    const Place place = place_of(input, input);
    const std::string name = fs::path(input).filename().string();
    // An output beside the slices that fits their pattern would be read as a slice by the next run,
    // and replaces one now.
    return output.exists && same(output.folder, place.folder) &&
           fnmatch(shell_pattern(name).c_str(), output.target.filename().c_str(), 0) == 0;
}

// A report is replaced without a question, as runs are repeated. A mistyped path must not cost a
// volume or a mesh.
bool is_report(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    char first = 0;
    // An empty file may be replaced, too.
    return !(file >> first) || first == '{';
}

void refuse_input(const Place& file, const std::vector<std::string>& inputs)
{
    for (const std::string& input : inputs) {
        if (input.empty() || !is_input(file, input))
            continue;
        std::string sentence = file.path == file.output ? "" : "the file '" + file.path + "' of ";
        sentence += "the output '" + file.output + "' is the input '" + input + "', or a file of it";
        throw refused(sentence);
    }
}

Failure one_file_twice(const Place& a, const Place& b)
{
    const std::string& link = fs::is_symlink(fs::symlink_status(a.path)) ? a.path : b.path;
    return refused("two files of the output '" + a.output + "' are one file: '" + link + "' is a link");
}

// All files of an output, each its own. Files that are there and are one by a hard link come to be two.
std::vector<Place> places_of(const std::string& output, const FilesBeside& files_beside)
{
    std::vector<std::string> files = files_of(output);
    const std::vector<std::string> beside = files_beside ? files_beside(output) : std::vector<std::string>();
    files.insert(files.end(), beside.begin(), beside.end());
    std::vector<Place> places;
    for (const std::string& file : files) {
        const Place place = place_of(file, output);
        for (const Place& other : places)
            if (same_place(place, other))
                throw one_file_twice(other, place);
        places.push_back(place);
    }
    return places;
}

// Of two outputs with one file.
std::string sentence_of(const Place& a, const Place& b)
{
    if (a.output == b.output)
        return "the output '" + a.output + "' is given twice";
    const std::string both = "the outputs '" + a.output + "' and '" + b.output + "' ";
    if (a.path == a.output && b.path == b.output)
        return both + "are one file";
    return both + "have one file: '" + (a.path == a.output ? b : a).path + "'";
}

}  // namespace

void refuse_conflicts(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                      const std::string& json, const FilesBeside& files_beside)
{
    // The report is an output as the others are.
    std::vector<std::string> all = outputs;
    if (!json.empty() && json != "-")
        all.push_back(json);
    std::vector<Place> taken;
    for (const std::string& path : all) {
        const std::vector<Place> files = places_of(path, files_beside);
        for (const Place& file : files) {
            refuse_input(file, inputs);
            // Two outputs of one name would leave the one that is written last, without a word.
            for (const Place& other : taken)
                if (same_file(file, other))
                    throw refused(sentence_of(other, file));
        }
        taken.insert(taken.end(), files.begin(), files.end());
    }
    struct stat status = {};
    if (!json.empty() && json != "-" && stat(json.c_str(), &status) == 0 && S_ISREG(status.st_mode) && !is_report(json))
        throw refused("the report would replace '" + json + "', which is no report");
}

}  // namespace cleft_cli
