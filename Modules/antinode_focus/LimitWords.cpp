#include "LimitWords.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

#include <cmath>
#include <stdexcept>

namespace antinode
{
namespace
{
constexpr double reachedShare = 0.99; // the grid of the limits leaves 0.5 %
constexpr double roundingShare = 1 + 1e-6;
constexpr double perMicro = 1e-6; // from V/s to V/us
} // namespace

bool isReached (const LimitUse& use)
{
    return use.share() >= reachedShare;
}

std::string limitName (LimitKind kind)
{
    switch (kind)
    {
        case LimitKind::ceramic:
            return "voltage limit of the ceramic";
        case LimitKind::focus:
            return "voltage limit of the focus";
        case LimitKind::amplifier:
            return "full scale of the amplifier";
        case LimitKind::fullScale:
            return "full scale of the device";
        case LimitKind::slew:
            return "slew limit";
        case LimitKind::current:
            return "current limit";
    }

    throw std::logic_error ("a limit without a name");
}

std::string limitField (LimitKind kind)
{
    switch (kind)
    {
        case LimitKind::ceramic:
            return "device: voltage limit";
        case LimitKind::focus:
            return "focus: voltage limit";
        case LimitKind::amplifier:
            return "output: full scale";
        case LimitKind::fullScale:
            return "device: full scale";
        case LimitKind::slew:
            return "device: slew limit";
        case LimitKind::current:
            return "device: current limit";
    }

    throw std::logic_error ("a limit without a field");
}

std::string limitAmount (LimitKind kind, double amount)
{
    switch (kind)
    {
        case LimitKind::slew:
            return inWords (amount * perMicro) + " V/us";
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
                             : use.kind == LimitKind::current ? " draws "
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
