#include "UniversalResponses.h"

#include "UniversalRecordText.h"
#include <antinode_base/InputError.h>

#include <set>

namespace antinode
{
namespace
{
constexpr int frequencyResponseFunction = 4, alongZ = 3;
constexpr int velocity = 11, force = 13, frequency = 18;

UniversalNodes makeNodes (const Eigen::MatrixX2d& points)
{
    constexpr int colour = 8;
    UniversalNodes nodes;
    nodes.places = Eigen::MatrixX3d::Zero (points.rows(), 3);
    nodes.places.leftCols (2) = points;

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        nodes.labels.push_back (p + 1);
        nodes.systems.push_back ({ 0, 0, colour });
    }

    return nodes;
}

/** The lines at which all responses that have any are finite; none if nothing was measured. */
std::vector<Eigen::Index> finiteLines (const FrequencyResponses& responses)
{
    Eigen::Array<bool, Eigen::Dynamic, 1> areFinite =
        Eigen::Array<bool, Eigen::Dynamic, 1>::Constant (responses.frequencies.size(), true);
    auto isMeasured = false;

    for (const auto& values : responses.values)
        for (const auto& response : values.colwise())
            if (const auto finite = response.array().isFinite().eval(); finite.any())
            {
                areFinite = areFinite && finite;
                isMeasured = true;
            }

    std::vector<Eigen::Index> lines;

    for (Eigen::Index f = 0; f < areFinite.size(); ++f)
        if (isMeasured && areFinite[f])
            lines.push_back (f);

    return lines;
}

/** All that the functions have in common. The abscissa is listed: six digits of a step would not do. */
UniversalFunction commonFunction (const FrequencyResponses& responses, const std::vector<Eigen::Index>& lines)
{
    UniversalFunction function;
    function.encoding = UniversalEncoding::littleEndian;
    function.lines = { "Velocity of points per drive", "Antinode " ANTINODE_VERSION, "NONE", "NONE", "NONE" };
    function.functionType = frequencyResponseFunction;
    function.ordinateType = 6;
    function.isEven = false;
    function.statedCount = static_cast<UniversalLabel> (lines.size());
    function.abscissae = responses.frequencies (lines);
    function.abscissa = { frequency, {}, "Frequency", "Hz" };
    function.ordinate = { velocity, {}, "Velocity", "m/s" };
    function.denominator = responses.drive == DriveQuantity::force ? UniversalAxis { force, {}, "Force", "N" }
                                                                   : UniversalAxis { 0, {}, "Voltage", "V" };
    return function;
}

/** Names of references as ten columns hold them; D1, D2 ... where they would no longer differ. */
std::vector<std::string> entityNames (const std::vector<Reference>& references)
{
    constexpr std::size_t width = 10;
    std::vector<std::string> entities;
    std::set<std::string> different;

    for (const auto& reference : references)
    {
        entities.push_back (plainText (reference.name, width));
        different.insert (entities.back() == "NONE" ? "" : entities.back());
    }

    if (different.size() < references.size() || different.contains (""))
        for (std::size_t i = 0; i < entities.size(); ++i)
            entities[i] = "D" + std::to_string (i + 1);

    return entities;
}
} // namespace

std::vector<UniversalSet> responseSets (const FrequencyResponses& responses)
{
    const auto lines = finiteLines (responses);

    if (lines.empty())
        throw InputError ("frequency responses", "have no line with finite values everywhere; nothing can be written");

    UniversalUnits units { 1, "SI: Meter (newton)", 2, 1, 1, 1, 273.14999999999998 };
    std::vector<UniversalSet> sets { units, makeNodes (responses.points) };
    const auto common = commonFunction (responses, lines);
    const auto entities = entityNames (responses.references);

    for (std::size_t i = 0; i < responses.values.size(); ++i)
        for (Eigen::Index p = 0; p < responses.points.rows(); ++p)
        {
            auto function = common;
            function.identification = static_cast<UniversalLabel> (sets.size());
            function.response = { "NONE", p + 1, alongZ };
            const auto& reference = responses.references[i];
            function.reference = reference.point ? UniversalPlace { entities[i], *reference.point + 1, alongZ }
                                                 : UniversalPlace { entities[i], 0, 0 };
            function.values = responses.values[i].col (p) (lines);

            if (function.values.array().isFinite().all())
                sets.emplace_back (std::move (function));
        }

    return sets;
}
} // namespace antinode
