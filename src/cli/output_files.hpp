// Where results go: looked at before the work starts, so that hours are not lost to a misspelt folder.
#pragma once

#include "cleft/cleft_io.h"

#include <string>
#include <vector>

namespace cleft_cli
{

// A place that was checked.
struct OutputFile {
    std::string path;
    cleft_io_format format = CLEFT_FORMAT_BY_NAME;
};

// Refuses a path whose extension no writer has, or whose folder cannot be written to. ".msh" becomes version 2.2 if
// `msh_version` says so.
OutputFile checked_mesh_output(const std::string& path, const std::string& msh_version);
// Likewise for a sizing field.
void check_sizing_output(const std::string& path);
// Likewise for a picture.
void check_picture_output(const std::string& path);
// Likewise for a view.
void check_page_output(const std::string& path);
// Nothing to check for "" and "-".
void check_json_output(const std::string& path);

// The files that are written for an output of this path, which is the first. TetGen's meshes are three.
std::vector<std::string> files_of(const std::string& path);
// Refuses a place of a file that cannot be made, as of a folder, or in a folder that is not there.
void check_place(const std::string& path);
// Likewise for a file that is written beside one whose folder was looked at.
void check_place_beside(const std::string& path);

// The help text of formats that go in `direction` (CLEFT_IO_WRITES_MESH ...), from the component's table.
std::string format_help(int32_t direction);

}  // namespace cleft_cli
