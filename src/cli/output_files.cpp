// Looks at the places of outputs before the work begins: a mistake in a path costs no run.
#include "output_files.hpp"

#include "exit_code.hpp"
#include "interrupt.hpp"
#include "staged_outputs.hpp"
#include "text.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace cleft_cli
{
namespace
{

// Exit code 4, as for a failure while writing: scripts need not know when it was noticed.
Failure cannot_write(const std::string& sentence) { return {EXIT_CANNOT_WRITE, CLEFT_ERROR_FILE, sentence}; }

std::vector<cleft_io_format_description> formats(int32_t direction)
{
    std::vector<cleft_io_format_description> rows;
    for (int32_t index = 0; index < cleft_io_format_count(); ++index) {
        cleft_io_format_description row = {};
        row.struct_size = sizeof row;
        if (cleft_io_format_info(index, &row) == CLEFT_OK && (row.directions & direction) != 0)
            rows.push_back(row);
    }
    return rows;
}

// Longer than its extension: ".msh" alone is a hidden file without an extension.
bool ends_with_nocase(const std::string& text, const std::string& end)
{
    return text.size() > end.size() && strcasecmp(text.c_str() + text.size() - end.size(), end.c_str()) == 0;
}

bool has_extension_of(const std::string& path, const cleft_io_format_description& row)
{
    std::istringstream extensions(row.extensions);
    for (std::string extension; extensions >> extension;)
        if (ends_with_nocase(path, extension))
            return true;
    return false;
}

std::string extensions_text(int32_t direction)
{
    std::string text;
    for (const auto& row : formats(direction)) {
        std::istringstream extensions(row.extensions);
        for (std::string extension; extensions >> extension;)
            // MSH has two rows with one extension.
            if ((" " + text + " ").find(" " + extension + " ") == std::string::npos)
                text += (text.empty() ? "" : " ") + extension;
    }
    return text;
}

void check_extension(const std::string& path, int32_t direction)
{
    for (const auto& row : formats(direction))
        if (has_extension_of(path, row))
            return;
    throw cannot_write("'" + path + "': no format that can be written has this extension; there are " +
                       extensions_text(direction));
}

void check_kind(const std::string& path)
{
    struct stat status = {};
    const bool is_there = stat(path.c_str(), &status) == 0;
    // Any other error is about the folder.
    if (!is_there && (errno == ENAMETOOLONG || errno == ELOOP))
        throw cannot_write("'" + path + "' cannot be written: " + std::strerror(errno));
    // A rename would replace a device or a pipe by a plain file.
    if (is_there && !S_ISREG(status.st_mode))
        throw cannot_write("'" + path + "' is " + (S_ISDIR(status.st_mode) ? "a folder" : "no regular file"));
}

// The only way to know whether a file can be made in a folder is to make one.
void probe_folder_of(const std::string& path)
{
    const std::string folder = folder_of(link_target(path)).string();
    // Otherwise a signal between mkstemp() and unlink() would leave the probe behind.
    const SignalsLater later;
    // access() answers for the real user and knows nothing of full quotas, read-only mounts or
    // access lists of NFS.
    std::string probe = folder + "/.cleft-XXXXXX";
    const int file = mkstemp(probe.data());
    if (file < 0)
        throw cannot_write("'" + path + "' cannot be written: no file can be made in the folder '" + folder +
                           "': " + std::strerror(errno));
    close(file);
    unlink(probe.c_str());
}

}  // namespace

std::vector<std::string> files_of(const std::string& path)
{
    const std::vector<std::string> tetgen = {".node", ".ele", ".face"};
    std::vector<std::string> files = {path};
    const std::string own = std::filesystem::path(path).extension().string();
    const auto is_own = [&](const std::string& extension) { return strcasecmp(own.c_str(), extension.c_str()) == 0; };
    if (std::none_of(tetgen.begin(), tetgen.end(), is_own))
        return files;
    for (const std::string& extension : tetgen)
        if (!is_own(extension))
            files.push_back(std::filesystem::path(path).replace_extension(extension).string());
    return files;
}

void check_place(const std::string& path)
{
    check_kind(path);
    probe_folder_of(path);
}

void check_place_beside(const std::string& path)
{
    check_kind(path);
    // A link has a folder of its own.
    if (std::filesystem::is_symlink(std::filesystem::symlink_status(path)))
        probe_folder_of(path);
}

OutputFile checked_mesh_output(const std::string& path, const std::string& msh_version)
{
    check_extension(path, CLEFT_IO_WRITES_MESH);
    for (const std::string& file : files_of(path))
        file == path ? check_place(file) : check_place_beside(file);
    // --msh-version changes nothing for other extensions, so that it may stand in a script for
    // several outputs.
    const bool old = msh_version == "2.2" && ends_with_nocase(path, ".msh");
    return {path, old ? CLEFT_FORMAT_MSH22 : CLEFT_FORMAT_BY_NAME};
}

void check_sizing_output(const std::string& path)
{
    check_extension(path, CLEFT_IO_WRITES_SIZING);
    check_place(path);
}

void check_picture_output(const std::string& path)
{
    if (!ends_with_nocase(path, ".png"))
        throw cannot_write("'" + path + "': a picture is written as .png");
    check_place(path);
}

void check_page_output(const std::string& path)
{
    if (!ends_with_nocase(path, ".html") && !ends_with_nocase(path, ".htm"))
        throw cannot_write("'" + path + "': a view is written as .html");
    check_place(path);
}

void check_json_output(const std::string& path)
{
    struct stat status = {};
    // Devices and pipes are written to as they are; see write_json().
    const bool device = stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    if (path.empty() || path == "-" || device)
        return;
    try {
        check_place(path);
    } catch (Failure& failure) {
        // What cannot be written tells of no failure, of its own neither.
        failure.is_reported = false;
        throw;
    }
}

std::string format_help(int32_t direction)
{
    std::ostringstream help;
    for (const auto& row : formats(direction))
        help << "  " << left(row.extensions, 18) << " " << row.text << "\n";
    return help.str();
}

}  // namespace cleft_cli
