// Joins lists of labels on the command line before CLI11 sees them.
#include "label_lists.hpp"

#include <unistd.h>

#include <regex>

namespace cleft_cli
{
namespace
{

bool is_label(const std::string& word)
{
    // A comma at the end joins "0, 4" to the next word.
    static const std::regex labels("-?[0-9]+(,-?[0-9]+)*,?");
    // An input may be called "7", as folders of DICOM often are.
    return std::regex_match(word, labels) && access(word.c_str(), F_OK) != 0;
}

}  // namespace

void join_label_lists(std::vector<std::string>& arguments)
{
    std::vector<std::string> joined;
    bool in_list = false;  // is the last word a list that may go on?
    bool begins = false;   // is the last word --strip, --only or --whole?
    for (const std::string& word : arguments) {
        // Only the words right behind the option are joined. CLI11 would take all words up to the
        // next option, inputs too.
        if (in_list && is_label(word)) {
            joined.back() += (joined.back().back() == ',' ? "" : ",") + word;
            continue;
        }
        in_list = begins && is_label(word);
        begins = word == "--strip" || word == "--only" || word == "--whole";
        joined.push_back(word);
    }
    arguments = std::move(joined);
}

}  // namespace cleft_cli
