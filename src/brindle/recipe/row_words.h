/// Words of the table's rows: the jobs that an option is for and the numbers that it takes.
#pragma once

#include "brindle/option_table.h"
#include "brindle/waves/weight_check.h"

namespace brindle {

constexpr unsigned kStripe = static_cast<unsigned>(PatternJob::stripe);
constexpr unsigned kCurves = static_cast<unsigned>(PatternJob::curves);
constexpr unsigned kSample = static_cast<unsigned>(PatternJob::sample);
constexpr unsigned kAnimate = static_cast<unsigned>(PatternJob::animate);
constexpr unsigned kCompare = static_cast<unsigned>(PatternJob::compare);
constexpr unsigned kAll = kStripe | kCurves | kSample | kAnimate | kCompare;

constexpr NumberRange kAnyNumber = {};
constexpr NumberRange kNotNegative = {.least = 0};
constexpr NumberRange kPositive = {.least = 0, .above_least = true};
constexpr NumberRange kShare = {.least = 0, .most = 1};
constexpr NumberRange kWeight = {.least = 0, .most = kLargestWeight};
constexpr NumberRange kPixels = {.least = 0, .most = 10000, .above_least = true};

}  // namespace brindle
