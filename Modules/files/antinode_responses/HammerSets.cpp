#include "CoherenceSet.h"
#include "HammerMeasurement.h"
#include "UniversalResponses.h"

#include <algorithm>

namespace antinode
{
namespace
{
/** Own numbers where all names are different ones of them, else 1, 2, ... in the order of the points. */
std::vector<UniversalLabel> nodeNumbers (const std::vector<HammerPoint>& points)
{
    constexpr std::size_t mostDigits = 9;
    const auto isNumber = [] (const HammerPoint& point)
    {
        return ! point.name.empty() && point.name.size() <= mostDigits && point.name.front() != '0'
               && point.name.find_first_not_of ("0123456789") == std::string::npos;
    };
    const auto areNumbers = std::all_of (points.begin(), points.end(), isNumber);
    std::vector<UniversalLabel> nodes;

    for (std::size_t i = 0; i < points.size(); ++i)
        if (areNumbers)
            nodes.push_back (std::stoll (points[i].name));
        else if (i > 0 && points[i].name == points[i - 1].name)
            nodes.push_back (nodes.back());
        else
            nodes.push_back (i == 0 ? 1 : nodes.back() + 1);

    return nodes;
}

/** Each node once. */
UniversalNodes withNumbers (const UniversalNodes& rows, const std::vector<UniversalLabel>& numbers)
{
    UniversalNodes nodes;
    std::vector<Eigen::Index> kept;

    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (i == 0 || numbers[i] != numbers[i - 1])
        {
            nodes.labels.push_back (numbers[i]);
            nodes.systems.push_back (rows.systems[i]);
            kept.push_back (static_cast<Eigen::Index> (i));
        }

    nodes.places = rows.places (kept, Eigen::all);
    return nodes;
}
} // namespace

std::vector<UniversalSet> hammerSets (const HammerMeasurement& measurement)
{
    auto sets = responseSets (measurement.responses);
    const auto numbers = nodeNumbers (measurement.points);
    const auto placeOf = [&] (UniversalPlace& place)
    {
        if (place.node == 0)
            return;

        const auto row = static_cast<std::size_t> (place.node - 1);
        place.node = numbers[row];
        place.direction = measurement.points[row].axis;
    };
    std::vector<UniversalSet> coherences;
    std::vector<std::string> entities;

    for (auto& set : sets)
        if (auto* const nodes = std::get_if<UniversalNodes> (&set))
            *nodes = withNumbers (*nodes, numbers);
        else if (auto* const function = std::get_if<UniversalFunction> (&set))
        {
            if (entities.empty() || entities.back() != function->reference.entity)
                entities.push_back (function->reference.entity);

            const Eigen::VectorXd coherence = measurement.coherence[entities.size() - 1].col (
                static_cast<Eigen::Index> (function->response.node - 1));
            placeOf (function->response);
            placeOf (function->reference);

            if (measurement.test.windowDecay > 0)
                function->lines[2] = windowDecayLine (measurement.test.windowDecay);

            if (coherence.allFinite())
                coherences.emplace_back (coherenceSet (*function, coherence));
        }

    sets.insert (sets.end(), coherences.begin(), coherences.end());
    return sets;
}
} // namespace antinode
