// Tables of names of labels.
#pragma once

#include "session.hpp"

#include <string>

namespace cleft_cli
{

// --names, for `what`: "Names of labels in the legend".
void add_names_to(CLI::App& app, std::string& path, const std::string& what);

// Names the labels by the table; nothing for "".
void read_names(const Session& session, const std::string& path, cleft_volume* volume);
void read_names(const Session& session, const std::string& path, cleft_mesh* mesh);

}  // namespace cleft_cli
