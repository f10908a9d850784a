// Local volume feedback on the weights of a label map.
#pragma once

#include "base/run.hpp"
#include "volume/label_map.hpp"

namespace cleft
{

// One round of feedback on the weights A, see label_weights.hpp. The second damps what the first one overshot.
enum class FeedbackRound { first, second };
template <class Label>
void feed_back_volume(LabelMap<Label>& map, FeedbackRound round, const Run& run);

}  // namespace cleft
