#include "UniversalResultsReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <variant>

namespace antinode
{
namespace
{
constexpr int normalMode = 2, complexModes[] = { 3, 7 }, staticCase = 1;
constexpr int displacement = 8, reactionForce = 9;

/** Sets of one universal file, put together. */
class Collector
{
public:
    explicit Collector (std::string name) : source (std::move (name)) {}

    void operator() (const UniversalUnits& set) { units = set; }

    void operator() (const UniversalNodes& set)
    {
        if (! results.labels.empty())
            throw InputError (source, "has two sets of nodes; allowed: one of type 15 or 2411");

        results.labels = set.labels;
        results.places = set.places;

        for (std::size_t n = 0; n < set.labels.size(); ++n)
            indices.emplace (set.labels[n], static_cast<Eigen::Index> (n));
    }

    void operator() (const UniversalElements& set)
    {
        for (const auto& element : set.elements)
        {
            MeshElement found { element.head[3], {} };

            for (const auto label : element.nodes)
                found.nodes.push_back (indexOf (label));

            results.elements.push_back (std::move (found));
        }
    }

    void operator() (const UniversalShape& set)
    {
        take ({ set.analysisType, set.specificType, set.reals }, set.isComplex, vectors (set.nodes, set.values));
    }

    void operator() (const UniversalResults& set)
    {
        constexpr int atNodes = 1, firstComplex = 5;

        if (set.location != atNodes || set.results.empty())
            return;

        std::vector<UniversalLabel> nodes;
        Eigen::MatrixXcd values (static_cast<Eigen::Index> (set.results.size()), set.results.front().values.size());

        for (std::size_t n = 0; n < set.results.size(); ++n)
        {
            if (set.results[n].head.empty() || set.results[n].values.size() != values.cols())
                throw InputError (
                    source, "has a set 2414 with nodes of different numbers of values; allowed: one number for all");

            nodes.push_back (set.results[n].head.front());
            values.row (static_cast<Eigen::Index> (n)) = set.results[n].values.transpose();
        }

        take ({ set.kind[1], set.kind[3], realsOf (set) }, set.kind[4] >= firstComplex, vectors (nodes, values));
    }

    void operator() (const auto&) {}

    ElementResults finish()
    {
        if (units)
            toSi();

        return std::move (results);
    }

private:
    /** What a set says of its values. */
    struct Head
    {
        int analysis, quantity;
        std::vector<double> reals;
    };

    Eigen::Index indexOf (UniversalLabel label) const
    {
        const auto found = indices.find (label);

        if (found == indices.end())
            throw InputError (source,
                              "has values at node " + std::to_string (label)
                                  + ", which it does not define; allowed: nodes of a set 15 or 2411 before them");

        return found->second;
    }

    Eigen::MatrixX3cd vectors (const std::vector<UniversalLabel>& nodes, const Eigen::MatrixXcd& values) const
    {
        if (results.labels.empty())
            throw InputError (source, "has results before its nodes; allowed: a set 15 or 2411 first");

        Eigen::MatrixX3cd result = Eigen::MatrixX3cd::Zero (results.places.rows(), 3);

        if (values.cols() < 3)
            return result;

        for (std::size_t n = 0; n < nodes.size(); ++n)
            result.row (indexOf (nodes[n])) = values.row (static_cast<Eigen::Index> (n)).head (3);

        return result;
    }

    /** In a set 2414 of a normal mode: 4 unused reals behind time, frequency, eigenvalue and modal mass; as in a
     * set 55. */
    static std::vector<double> realsOf (const UniversalResults& set)
    {
        if (set.kind[1] == normalMode)
            return { set.reals[1], set.reals[3], set.reals[4], set.reals[5] };

        return { set.reals[6], set.reals[7], set.reals[8], set.reals[9] };
    }

    void take (const Head& head, bool isComplex, const Eigen::MatrixX3cd& values)
    {
        const auto isMotion = head.quantity == displacement || head.quantity == 0;

        if (head.analysis == normalMode && isMotion)
            addNormalMode (head.reals, values);
        else if ((head.analysis == complexModes[0] || head.analysis == complexModes[1]) && isMotion && isComplex)
            addComplexMode (head.reals, values);
        else if (head.analysis == staticCase && head.quantity == reactionForce)
            results.blockedForces.emplace_back (values.real());
        else if (head.analysis == staticCase && isMotion)
            results.staticDisplacements.emplace_back (values.real());
    }

    void addNormalMode (const std::vector<double>& reals, const Eigen::MatrixX3cd& values)
    {
        if (reals.size() < 2 || ! (reals[1] > 0))
            throw InputError (source, "has a mode without modal mass; allowed: above 0, 1 for mass-normalised shapes");

        const auto damping = reals.size() > 2 ? reals[2] : 0;
        results.modes.push_back ({ reals[0], damping, values / std::sqrt (reals[1]) });
    }

    /** Scaled so that modal A is 2 j Im (eigenvalue), as that of a real mode of mass 1 is. */
    void addComplexMode (const std::vector<double>& reals, const Eigen::MatrixX3cd& values)
    {
        if (reals.size() < 4)
            throw InputError (source, "has a complex mode without modal A; allowed: eigenvalue and modal A");

        const std::complex<double> pole (reals[0], reals[1]), modalA (reals[2], reals[3]);

        if (pole.imag() < 0)
            return; // Its conjugate is there.

        if (! (std::abs (modalA) > 0) || ! (std::abs (pole) > 0))
            throw InputError (source, "has a complex mode whose eigenvalue or modal A is 0; allowed: other numbers");

        const auto factor = std::sqrt (std::complex<double> (0, 2 * pole.imag()) / modalA);
        results.modes.push_back (
            { std::abs (pole) / (2 * std::numbers::pi), -pole.real() / std::abs (pole), factor * values });
    }

    /** Lengths and forces by their factors; masses follow from N s^2 / m. */
    void toSi()
    {
        const auto length = units->length, force = units->force;
        results.places /= length;

        for (auto& forces : results.blockedForces)
            forces /= force;

        for (auto& displacements : results.staticDisplacements)
            displacements /= length;

        for (auto& mode : results.modes)
            mode.shape *= std::sqrt (force / length);
    }

    std::string source;
    std::optional<UniversalUnits> units;
    std::map<UniversalLabel, Eigen::Index> indices;
    ElementResults results;
};
} // namespace

ElementResults universalResults (const std::vector<UniversalSet>& sets, const std::string& source)
{
    Collector collector (source);

    for (const auto& set : sets)
        std::visit (collector, set);

    return collector.finish();
}
} // namespace antinode
