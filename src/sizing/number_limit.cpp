// A search for the least size at which the number is kept to.
#include "sizing/number_limit.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace cleft
{

namespace
{

// Cells of an octree are no longer than the box is thin, whatever their size is to be: a plate can have many more of
// them than the sizes ask for.
void refuse_flat_box(double of_sizes, double expected, double wanted)
{
    // Trees come in steps of eight times the number, and have half as many tetrahedra again as particles.
    constexpr double kOfSteps = 4;
    if (expected <= kOfSteps * std::max(wanted, of_sizes))
        return;
    throw Error(CLEFT_ERROR_TOO_LARGE, "the box is so thin that the background has about " + count_text(expected) +
                                           " tetrahedra, whatever their size, more than max_tets, " +
                                           count_text(wanted) + ": set a greater max_tets or another background");
}

// A size that is given for interfaces, labels or points holds whatever the number comes to.
void warn_of_raised(double least, double asked, double expected, double wanted, const Run& run)
{
    // The expected number is off by some percent: what is so little above says nothing.
    constexpr double kNearly = 1.2;
    const std::string raised = "the features ask for about " + count_text(asked) +
                               " tetrahedra: the least size was raised to " + number_text(least);
    if (expected > kNearly * wanted)
        run.warn(raised + ", but the box and the given sizes of interfaces, labels or points still ask for about " +
                 count_text(expected) + ", more than max_tets, " + count_text(wanted));
    else
        run.warn(raised + " to keep to max_tets, " + count_text(wanted));
}

}  // namespace

double keep_to_number(const NumberLimit& limit, const std::function<double(double raised)>& expected_at,
                      const std::function<double()>& of_sizes, const Run& run)
{
    // Thin structures fill a noisy volume, so that the number falls with a power of the least size between two and
    // three: with the mean of both, each round leaves a fifth of what was too many at most, so nine are enough for any
    // number. Each computes a whole field.
    constexpr int kMostRounds = 9;
    constexpr double kPower = 2.5;
    // Nearer than the estimate is anyway; also the least factor, so that each round changes the field.
    constexpr double kClose = 1.02;
    const double asked = expected_at(1);
    if (asked <= limit.wanted)
        return 1;
    double expected = asked, raised = 1;
    for (int round = 0; round < kMostRounds && expected > kClose * limit.wanted; ++round) {
        raised *= std::max(std::pow(expected / limit.wanted, 1 / kPower), kClose);
        const double before = std::exchange(expected, expected_at(raised));
        // No cell is longer than the box is thin, so that greater sizes change nothing.
        if (expected >= before && raised * limit.least_feature > limit.thinnest)
            break;
    }
    run.note("sizing.raised_size_min", raised * limit.least_feature);
    refuse_flat_box(of_sizes(), expected, limit.wanted);
    warn_of_raised(raised * limit.least_feature, asked, expected, limit.wanted, run);
    return raised;
}

}  // namespace cleft
