#include "ElementResults.h"

#include "ElementReaders.h"

#include <antinode_base/InputError.h>
#include <antinode_responses/UniversalFile.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace antinode
{
namespace
{
constexpr auto howToGet = "; Docs/Manual/importing.md says how to get them";

void append (std::vector<Eigen::MatrixX3d>& to, std::vector<Eigen::MatrixX3d>& from)
{
    std::move (from.begin(), from.end(), std::back_inserter (to));
}

void checkComplete (const ElementResults& results)
{
    if (results.modes.empty())
        throw InputError ("finite-element results",
                          std::string ("contain no modes; allowed: those of an analysis of frequencies with the "
                                       "displacements of all nodes")
                              + howToGet);

    if (results.blockedForces.empty())
        throw InputError ("finite-element results",
                          std::string ("contain no reaction forces of a ceramic; allowed: a static case for each "
                                       "ceramic, in which all nodes are held and the ceramic strains as at 1 V")
                              + howToGet);

    if (! results.staticDisplacements.empty() && results.staticDisplacements.size() != results.blockedForces.size())
        throw InputError ("finite-element results",
                          "contain " + std::to_string (results.staticDisplacements.size())
                              + " static displacements and reaction forces of "
                              + std::to_string (results.blockedForces.size())
                              + " ceramics; allowed: one of each for a ceramic, or reaction forces alone");
}
} // namespace

bool ElementResults::hasComplexModes() const
{
    return std::any_of (modes.begin(), modes.end(),
                        [] (const ElementMode& mode) { return ! mode.shape.imag().isZero (0); });
}

ElementResults readElementResults (std::string_view bytes, const std::string& source)
{
    constexpr std::string_view tableMark = "E I G E N V A L U E", calculixMark = "    1C";

    if (bytes.starts_with (calculixMark))
        return readCalculixResults (bytes, source);

    if (bytes.substr (0, 4096).find (tableMark) != std::string_view::npos)
    {
        ElementResults table;
        table.totalMass = calculixMass (bytes);
        return table;
    }

    return universalResults (readUniversalFile (bytes, source), source);
}

ElementResults fromMillimetres (ElementResults results)
{
    constexpr double millimetre = 1e-3, tonne = 1e3;
    results.places *= millimetre;
    results.totalMass *= tonne;

    for (auto& mode : results.modes)
        mode.shape /= std::sqrt (tonne);

    for (auto& displacements : results.staticDisplacements)
        displacements *= millimetre;

    return results;
}

ElementResults mergedResults (std::vector<ElementResults> all)
{
    ElementResults merged;

    for (auto& results : all)
    {
        merged.totalMass = std::max (merged.totalMass, results.totalMass);

        if (results.labels.empty())
            continue;

        if (merged.labels.empty())
        {
            merged.labels = results.labels;
            merged.places = results.places;
        }

        if (merged.labels != results.labels)
            throw InputError ("finite-element results",
                              "are of different meshes; allowed: files with the same nodes in the same order");

        if (merged.elements.empty())
            merged.elements = std::move (results.elements);

        if (merged.modes.empty())
            merged.modes = std::move (results.modes);

        append (merged.blockedForces, results.blockedForces);
        append (merged.staticDisplacements, results.staticDisplacements);
    }

    checkComplete (merged);
    return merged;
}
} // namespace antinode
