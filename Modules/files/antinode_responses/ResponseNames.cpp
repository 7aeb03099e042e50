#include "ResponseNames.h"

#include <algorithm>
#include <set>

namespace antinode
{
namespace
{
using Responses = std::vector<MeasuredResponse>;

/** Whether two responses of a list have this name empty and the other the same. */
bool collides (const Responses& responses, std::string MeasuredResponse::*name, std::string MeasuredResponse::*other)
{
    std::set<std::string> seen;
    return std::any_of (responses.begin(), responses.end(),
                        [&] (const auto& response)
                        { return (response.*name).empty() && ! seen.insert (response.*other).second; });
}

/** Points without names are numbered within their file where it has several for a reference. */
void numberColumns (Responses& responses)
{
    std::map<std::string, int> counts, numbers;

    for (const auto& response : responses)
        counts[response.reference] += response.point.empty() ? 1 : 0;

    for (auto& response : responses)
        if (response.point.empty() && counts[response.reference] > 1)
            response.point = std::to_string (++numbers[response.reference]);
}
} // namespace

std::vector<MeasuredResponse> namedResponses (const std::vector<MeasurementFile>& files)
{
    Responses all;
    std::vector<std::size_t> fileNumbers;

    for (std::size_t f = 0; f < files.size(); ++f)
    {
        auto responses = files[f].responses;
        numberColumns (responses);
        fileNumbers.resize (fileNumbers.size() + responses.size(), f + 1);
        std::move (responses.begin(), responses.end(), std::back_inserter (all));
    }

    const auto fill = [&] (std::string MeasuredResponse::*name, std::string MeasuredResponse::*other)
    {
        const auto byFile = collides (all, name, other);

        for (std::size_t i = 0; i < all.size(); ++i)
            if ((all[i].*name).empty())
                all[i].*name = byFile ? std::to_string (fileNumbers[i]) : "1";
    };
    fill (&MeasuredResponse::point, &MeasuredResponse::reference);
    fill (&MeasuredResponse::reference, &MeasuredResponse::point);
    return all;
}
} // namespace antinode
