#include "PointResponseFile.h"

#include "UniversalResponses.h"

#include "UniversalFile.h"
#include <antinode_base/InputError.h>

namespace antinode
{
namespace
{
constexpr int frequencyResponseType = 4, coherenceFunction = 6;

FrequencyResponses responsesAtPoint (const FrequencyResponses& all, Eigen::Index point)
{
    FrequencyResponses one { all.frequencies, all.drive, all.references, all.points.row (point), {}, {} };

    for (const auto& values : all.values)
        one.values.emplace_back (values.col (point));

    return one;
}

std::vector<const UniversalFunction*> functionsOfType (const std::vector<UniversalSet>& sets, int type)
{
    std::vector<const UniversalFunction*> functions;

    for (const auto& set : sets)
        if (const auto* const function = std::get_if<UniversalFunction> (&set);
            function != nullptr && function->functionType == type)
            functions.push_back (function);

    return functions;
}
} // namespace

std::string encodePoint (const SurfaceMeasurement& measurement, Eigen::Index point)
{
    auto sets = responseSets (responsesAtPoint (measurement.responses, point));
    std::vector<UniversalSet> coherences;
    std::size_t ceramic = 0;

    for (auto& set : sets)
    {
        if (auto* const nodes = std::get_if<UniversalNodes> (&set))
            nodes->labels.front() = point + 1;

        if (auto* const function = std::get_if<UniversalFunction> (&set))
        {
            const Eigen::VectorXd coherence = measurement.coherence[ceramic++].col (point);
            function->response.node = point + 1;

            if (coherence.allFinite())
                coherences.emplace_back (coherenceSet (*function, coherence));
        }
    }

    sets.insert (sets.end(), coherences.begin(), coherences.end());
    return encodeUniversalFile (sets);
}

void restorePoint (SurfaceMeasurement& measurement, Eigen::Index point, std::string_view bytes,
                   const std::string& source)
{
    const auto sets = readUniversalFile (bytes, source);
    const auto responses = functionsOfType (sets, frequencyResponseType),
               coherences = functionsOfType (sets, coherenceFunction);
    const auto lines = measurement.responses.frequencies.size();
    const auto ceramics = measurement.responses.values.size();
    const auto fits = [lines] (const auto* function) { return function->values.size() == lines; };

    if (responses.size() != ceramics || ! std::all_of (responses.begin(), responses.end(), fits)
        || ! std::all_of (coherences.begin(), coherences.end(), fits))
        throw InputError (source, "belongs to another measurement; remove it, or choose another folder");

    for (std::size_t i = 0; i < ceramics; ++i)
    {
        measurement.responses.values[i].col (point) = responses[i]->values;

        if (coherences.size() == ceramics)
            measurement.coherence[i].col (point) = coherences[i]->values.real();
    }
}
} // namespace antinode
