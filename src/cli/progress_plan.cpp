// Joins the progress of several calls of the library, each of which goes from 0 to 1.
#include "progress_plan.hpp"

#include <algorithm>
#include <utility>

namespace cleft_cli
{

ProgressPlan::ProgressPlan(std::vector<Part> parts) : parts_(std::move(parts))
{
    for (const Part& part : parts_)
        all_ += part.share;
}

void ProgressPlan::begin(const std::string& name)
{
    double before = 0;
    for (const Part& part : parts_) {
        if (part.name == name) {
            begin_ = before / all_;
            share_ = part.share / all_;
            return;
        }
        before += part.share;
    }
    begin_ = reached_;
    share_ = 0;
}

double ProgressPlan::at(double fraction_of_part)
{
    // Two calls in one part both begin at 0.
    reached_ = std::max(reached_, begin_ + share_ * std::clamp(fraction_of_part, 0.0, 1.0));
    return reached_;
}

}  // namespace cleft_cli
