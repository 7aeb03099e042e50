#include "LimitWords.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double reachedShare = 0.99; // the grid of the limits leaves 0.5 %
constexpr double roundingShare = 1 + 1e-6;

/** How a limit is called, and where it is set. */
struct LimitWord
{
    LimitKind kind;
    const char *name, *field;
};

constexpr std::array limitWords {
    LimitWord { LimitKind::ceramic, "voltage limit of the ceramic", "device: voltage limit" },
    LimitWord { LimitKind::focus, "voltage limit of the focus", "focus: voltage limit" },
    LimitWord { LimitKind::amplifier, "full scale of the amplifier", "output: full scale" },
    LimitWord { LimitKind::fullScale, "full scale of the device", "device: full scale" },
    LimitWord { LimitKind::slew, "slew limit", "device: slew limit" },
    LimitWord { LimitKind::current, "current limit", "device: current limit" }
};

const LimitWord& words (LimitKind kind)
{
    return *std::find_if (limitWords.begin(), limitWords.end(),
                          [kind] (const auto& each) { return each.kind == kind; });
}
} // namespace

bool isReached (const LimitUse& use)
{
    return use.share() >= reachedShare;
}

std::string limitName (LimitKind kind)
{
    return words (kind).name;
}

std::string limitField (LimitKind kind)
{
    return words (kind).field;
}

std::string limitAmount (LimitKind kind, double amount)
{
    switch (kind)
    {
        case LimitKind::slew:
            return inWords (amount / micro) + " V/us";
        case LimitKind::current:
            return inWords (amount * milli) + " mA";
        default:
            return inWords (amount) + " V";
    }
}

std::string limitedCeramic (const ModalModel& model, const LimitUse& use)
{
    const auto& name = model.ceramics[static_cast<std::size_t> (use.ceramic)].name;
    return "ceramic " + std::to_string (use.ceramic + 1) + (name.empty() ? "" : " (" + name + ")");
}

std::string limitTime (const LimitUse& use)
{
    const auto time = fixedText (std::abs (use.time) * milli, 3);

    if (time == fixedText (0, 3))
        return "at the focus";

    return time + (use.time < 0 ? " ms before" : " ms after") + " the focus";
}

std::string limitSentence (const ModalModel& model, const LimitUse& use)
{
    const auto* const verb = use.kind == LimitKind::slew      ? " changes by "
                             : use.kind == LimitKind::current ? " charges its capacitance with "
                                                              : " has ";
    const auto where = limitedCeramic (model, use) + verb + limitAmount (use.kind, use.used) + " of "
                       + limitAmount (use.kind, use.allowed) + ", " + limitTime (use);

    if (use.share() > roundingShare)
        return "The " + limitName (use.kind) + " is exceeded: " + where + ".";

    if (isReached (use))
        return "The " + limitName (use.kind) + " binds: " + where + ".";

    return "No limit binds; the nearest is the " + limitName (use.kind) + ": " + where + ".";
}
} // namespace antinode
