// Ranges of options of one number. What CLI11 says of its own has hundreds of digits.
#pragma once

#include "text.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

namespace cleft_cli
{

template <class Number, class IsRight>
CLI::Validator number_check(const IsRight& is_right, const std::string& range)
{
    return CLI::Validator(
        [=](const std::string& text) {
            Number number{};
            const bool is_number = CLI::detail::lexical_cast(text, number);
            return is_number && is_right(number) ? "" : "'" + text + "' is not a number in its range (" + range + ")";
        },
        "");
}

inline CLI::Validator number_above_zero(double greatest)
{
    return number_check<double>([=](double number) { return number > 0 && number <= greatest; },
                                "above 0, at most " + significant(greatest));
}

inline CLI::Validator positive_integer()
{
    return number_check<int64_t>([](int64_t number) { return number > 0; }, "whole, at least 1");
}

}  // namespace cleft_cli
