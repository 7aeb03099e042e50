#include "DescribedChain.h"

#include "DescriptionChecks.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
/** Puts the stretches of a line one after the other; edges closer than the tolerance become one. */
class LineElements
{
public:
    LineElements (const StructureCommon& commonToUse, double widthToUse, double length)
        : common (commonToUse), width (widthToUse), position (-length / 2), end (length / 2)
    {
    }

    void addCeramic (int index)
    {
        const auto& ceramic = common.ceramics[static_cast<std::size_t> (index)];
        const auto right = ceramic.x + ceramic.sizeX, last = end - right > edgeTolerance ? right : end;
        const auto bond = bondLength (common, width, ceramic);
        addBareTo (ceramic.x);

        if (bond > edgeTolerance)
            add (position + bond, looseSection (common, width, ceramic), {});

        add (last - bond, ceramicSection (common, width, ceramic), index);

        if (bond > edgeTolerance)
            add (last, looseSection (common, width, ceramic), {});
    }

    std::vector<ChainElement> finish()
    {
        addBareTo (end);
        return std::move (elements);
    }

private:
    void addBareTo (double right)
    {
        if (right - position > edgeTolerance)
            add (right, bareSection (common, width), {});
    }

    void add (double right, const BeamSection& section, std::optional<int> ceramic)
    {
        elements.push_back ({ position, right - position, 1, 0, section, true, ceramic });
        position = right;
    }

    const StructureCommon& common;
    double width, position, end;
    std::vector<ChainElement> elements;
};

std::vector<ChainElement> lineElements (const StructureCommon& common, double width, double length)
{
    std::vector<int> order (common.ceramics.size());
    std::iota (order.begin(), order.end(), 0);
    const auto left = [&] (int index) { return common.ceramics[static_cast<std::size_t> (index)].x; };
    std::stable_sort (order.begin(), order.end(), [&] (int a, int b) { return left (a) < left (b); });

    LineElements line (common, width, length);

    for (const auto index : order)
        line.addCeramic (index);

    return line.finish();
}

Restraint toRestraint (EdgeCondition condition)
{
    const auto clamped = condition == EdgeCondition::clamped;
    return { clamped, clamped || condition == EdgeCondition::simplySupported,
             clamped || condition == EdgeCondition::guided };
}
} // namespace

ElementChain makeChain (const BeamDescription& beam)
{
    return { lineElements (beam.common, beam.width, beam.length), toRestraint (beam.left), toRestraint (beam.right),
             false, beam.common.theory == BendingTheory::thick };
}

ElementChain makeChain (const StapleDescription& staple)
{
    const auto clamped = toRestraint (EdgeCondition::clamped);
    ElementChain chain { lineElements (staple.common, staple.width, staple.topLength), clamped, clamped, true,
                         staple.common.theory == BendingTheory::thick };
    ChainElement leg { 0, staple.legLength, 0, 1, bareSection (staple.common, staple.width), false, {} };
    chain.elements.insert (chain.elements.begin(), leg);
    leg.sine = -1;
    chain.elements.push_back (leg);
    return chain;
}
} // namespace antinode
