// What both programs do with their words.
#pragma once

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace cleft_cli
{

// The first screen that a new user sees: one line a command, and a path through them. `beside_version`: what else
// --version tells.
void describe(CLI::App& app, const std::string& what_it_does, const std::string& examples,
              const std::string& beside_version = "");

// What is to be printed in the place of a command's work: help or a version, or why the words are wrong.
struct Said {
    std::string text;
    bool is_complaint;
};
// Nothing if there is a command to run.
std::optional<Said> parse_words(CLI::App& app, int argc, char** argv);

}  // namespace cleft_cli
