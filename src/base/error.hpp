// How a stage refuses: it throws Error with a status of the C interface and one clear sentence for the user.
#pragma once

#include "cleft/cleft_status.h"

#include <stdexcept>
#include <string>

namespace cleft
{

class Error : public std::runtime_error
{
public:
    Error(cleft_status status, const std::string& sentence) : std::runtime_error(sentence), status_(status) {}
    cleft_status status() const { return status_; }

private:
    cleft_status status_;
};

}  // namespace cleft
