// The values of indicator functions as the stages use them: finite floats whose products do not overflow.
#pragma once

#include "base/array.hpp"
#include "base/grid.hpp"
#include "base/run.hpp"

namespace cleft
{

// Copies of the fields. NaN and infinity are an Error. Values beyond kGreatestValue, which stand for "far away", become
// kFarValue times the greatest magnitude that all the fields have within it, of their sign; a warning reports them.
// Taken as they are they would draw the cubic interpolation over zero where the field has none.
template <class Value>
Array<Array<float>> bounded_values(const Array<const Value*>& fields, const Grid& grid, const Run& run);

}  // namespace cleft
