// Lists of labels on the command line.
#pragma once

#include <string>
#include <vector>

namespace cleft_cli
{

// "--strip 0 4 7 head.nrrd" becomes "--strip 0,4,7 head.nrrd": without it, a list that ends only where the next option
// begins would swallow the inputs. A word that names a file ends the list too.
// `arguments` are those behind the name of the program, in the order of the command line.
void join_label_lists(std::vector<std::string>& arguments);

}  // namespace cleft_cli
