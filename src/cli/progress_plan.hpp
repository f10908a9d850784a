// Which part of a run each of its calls is.
#pragma once

#include <string>
#include <vector>

namespace cleft_cli
{

// Something that the command does, and its share of the time, in any unit.
struct Part {
    std::string name;
    double share = 1;
};

class ProgressPlan
{
public:
    // The parts in their order. A run may leave some out.
    explicit ProgressPlan(std::vector<Part> parts);

    // One that is not in the plan has no share.
    void begin(const std::string& name);
    // How much of the run is done when so much of the part is done. It never falls.
    double at(double fraction_of_part);

private:
    std::vector<Part> parts_;
    double all_ = 0;
    double begin_ = 0, share_ = 0;  // of the part that runs, as fractions of the run
    double reached_ = 0;
};

}  // namespace cleft_cli
