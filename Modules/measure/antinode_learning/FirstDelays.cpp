#include "FirstDelays.h"

#include "PlayPrediction.h"

#include <antinode_numerics/Median.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::size_t mostLikely = 24; // delays that are compared by the beginning of the record
constexpr std::size_t mostTried = 5;   // of them that are tried on the whole record
constexpr double surelyRight = 1.5;    // times the noise: a delay that leaves less of the beginning is the right one
constexpr std::size_t fewCompared = 4; // so many delays are compared before one of them stands out
constexpr double farLess = 0.2;        // of the next one's misfit: what a delay leaves that stands out
constexpr double hardlyAny = 0.05;     // the same of the median of the others
constexpr double step = 10e-6;         // s, between delays beside the best one: a third of the highest modes' periods
constexpr int mostSteps = 8;           // to either side: a model that is off has its maxima some periods beside

struct ComparedDelay
{
    double delay = 0;              ///< s
    std::array<double, 2> misfits; ///< Of the beginning, by each bound.

    double least() const { return std::min (misfits[0], misfits[1]); }
};

bool isNearer (const ComparedDelay& one, const ComparedDelay& other)
{
    return one.least() < other.least();
}

/** Whether the least one is far less than all others. What modes beyond the model do is left by the right delay too, so
    the noise alone is no measure. */
bool oneStandsOut (std::vector<ComparedDelay> delays)
{
    if (delays.size() < fewCompared)
        return false;

    std::sort (delays.begin(), delays.end(), isNearer);
    std::vector<double> others;

    for (auto each = delays.begin() + 1; each != delays.end(); ++each)
        others.push_back (each->least());

    const auto least = delays.front().least(), next = others.front();
    return least < farLess * next && least < hardlyAny * median (std::move (others));
}

/** s: the likeliest delay by the correlation, since beginnings can mislead, then those that explain the beginning best,
    those of the two bounds in turn. */
std::vector<double> delaysWorthTrying (const std::vector<ComparedDelay>& compared, double likeliest)
{
    std::array ranked { compared, compared };
    std::vector<double> best { likeliest };

    for (std::size_t bound = 0; bound < ranked.size(); ++bound)
        std::sort (ranked[bound].begin(), ranked[bound].end(),
                   [bound] (const auto& one, const auto& other) {
                       return std::pair (one.misfits[bound], one.delay) < std::pair (other.misfits[bound], other.delay);
                   });

    for (std::size_t i = 0; i < compared.size() && best.size() < mostTried; ++i)
        for (const auto& each : ranked)
            if (std::find (best.begin(), best.end(), each[i].delay) == best.end())
                best.push_back (each[i].delay);

    best.resize (std::min (best.size(), mostTried));
    return best;
}

/** The best of the delays beside one, or the first that is surely right. */
template <typename Compare>
ComparedDelay bestBeside (ComparedDelay best, double earliest, double latest, const Compare& compare)
{
    const auto middle = best.delay;

    for (int i = 1; i <= mostSteps; ++i)
        for (const auto delay : { middle - i * step, middle + i * step })
        {
            if (delay < earliest || delay > latest)
                continue;

            if (const auto now = compare (delay); isNearer (now, best))
                best = now;

            if (best.least() < surelyRight)
                return best;
        }

    return best;
}
} // namespace

std::vector<double> firstDelays (const ModalModel& nominal, const std::vector<Sensor>& sensors,
                                 const ModeSpread& deviations, const PlayedRecording& recording)
{
    auto likely = delaysBy (meanModel (nominal, deviations.frequencies), sensors, recording, mostLikely);

    if (likely.size() == 1)
        return likely;

    constexpr auto none = std::numeric_limits<double>::infinity();
    std::array least { none, none }; // of each bound
    const auto compare = [&] (double delay) -> ComparedDelay
    {
        const ComparedDelay now { delay,
                                  misfitsOfBeginning (nominal, sensors, deviations, withDelay (recording, delay),
                                                      surelyRight, { least[0] / hardlyAny, least[1] / hardlyAny }) };

        for (std::size_t bound = 0; bound < least.size(); ++bound)
            least[bound] = std::min (least[bound], now.misfits[bound]);

        return now;
    };
    std::vector<ComparedDelay> compared;

    for (const auto delay : likely)
    {
        compared.push_back (compare (delay));

        if (compared.back().least() < surelyRight)
            return { delay };

        if (oneStandsOut (compared))
            return { std::min_element (compared.begin(), compared.end(), isNearer)->delay };
    }

    compared.push_back (bestBeside (*std::min_element (compared.begin(), compared.end(), isNearer), recording.delay,
                                    recording.delay + recording.delaySpan, compare));

    if (compared.back().least() < surelyRight)
        return { compared.back().delay };

    return delaysWorthTrying (compared, delaysBy (nominal, sensors, recording, 1).front());
}
} // namespace antinode
