#include "LimitUse.h"

#include "DriveAllocation.h"
#include "FreeSamples.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
/** Of what is nearly equal the first counts: rounding must not choose. */
constexpr double noticeable = 1 + 1e-4;

/** The voltages of a program or their slopes, wherever they are asked for. */
class ProgramVoltages
{
public:
    explicit ProgramVoltages (const VoltageProgram& programToUse) : program (programToUse)
    {
        for (const auto& oscillation : program.oscillations)
        {
            drives.push_back ({ oscillation });
            first = std::min (first, oscillation.start);
            last = std::max (last, oscillation.end);
            highest = std::max (highest, std::abs (oscillation.exponent()) / (2 * std::numbers::pi));
        }
    }

    /** N_b x N from one time to another, on the grid of the limits or a finer one. */
    Eigen::MatrixXd between (double from, double to, bool isSlope, int samplesPerCycle) const
    {
        return program.allocation
               * (isSlope ? sampleSlopes (drives, from, to, samplesPerCycle)
                          : sampleDrives (drives, from, to, samplesPerCycle));
    }

    const VoltageProgram& program;
    std::vector<std::vector<Oscillation>> drives;
    double first = std::numeric_limits<double>::infinity(), last = -first;
    double highest = 0; ///< Hz
};

/** The largest share of a limit so far. */
struct LargestShare
{
    double share = 0, time = 0;
    Eigen::Index ceramic = 0;

    /** @param limits  N_b; 0: none */
    void look (const Eigen::MatrixXd& values, const Eigen::VectorXd& limits, double from, double to)
    {
        const auto interval = values.cols() > 1 ? (to - from) / static_cast<double> (values.cols() - 1) : 0.0;

        for (Eigen::Index n = 0; n < values.cols(); ++n)
            for (Eigen::Index i = 0; i < values.rows(); ++i)
                if (const auto now = limits[i] > 0 ? std::abs (values (i, n)) / limits[i] : 0.0;
                    now > noticeable * share)
                {
                    share = now;
                    time = from + static_cast<double> (n) * interval;
                    ceramic = i;
                }
    }
};

/** On the grid first, then finer around the largest share. */
LargestShare largestShare (const ProgramVoltages& voltages, const Eigen::VectorXd& limits, bool isSlope)
{
    constexpr auto pieceCycles = 16.0;
    constexpr auto refinement = 64;
    LargestShare largest;
    const auto span = std::max (voltages.last - voltages.first, 0.0);
    const auto pieces =
        span > 0 ? std::max (1, static_cast<int> (std::ceil (span * voltages.highest / pieceCycles))) : 0;

    for (int n = 0; n < pieces; ++n)
    {
        checkWatch();
        const auto from = voltages.first + span * n / pieces;
        const auto to = voltages.first + span * (n + 1) / pieces;
        largest.look (voltages.between (from, to, isSlope, gridSamplesPerCycle), limits, from, to);
    }

    if (largest.share == 0)
        return largest;

    const auto interval = 1 / (voltages.highest * gridSamplesPerCycle);
    const auto from = std::max (largest.time - interval, voltages.first);
    const auto to = std::min (largest.time + interval, voltages.last);
    const auto fine = voltages.between (from, to, isSlope, refinement * gridSamplesPerCycle);
    Eigen::Index peak = 0;
    largest.share = fine.row (largest.ceramic).cwiseAbs().maxCoeff (&peak) / limits[largest.ceramic];
    largest.time = from + (to - from) * static_cast<double> (peak) / static_cast<double> (fine.cols() - 1);
    return largest;
}

LimitUse voltageUse (const ModalModel& model, const AllocationChoice& choice, const VoltageProgram& program,
                     const LargestShare& largest)
{
    const auto allowed = program.voltageLimits[largest.ceramic];
    return { voltageLimitKind (model, choice, static_cast<std::size_t> (largest.ceramic)),
             static_cast<int> (largest.ceramic), largest.time - program.focusTime, largest.share * allowed, allowed };
}

/** In the unit in which the limit was given. */
LimitUse slewUse (const ModalModel& model, const VoltageProgram& program, const LargestShare& largest)
{
    const auto& ceramic = model.ceramics[static_cast<std::size_t> (largest.ceramic)];
    const auto isCurrent = ceramic.currentLimit > 0 && ceramic.capacitance > 0
                           && ceramic.currentLimit / ceramic.capacitance <= ceramic.slewLimit;
    const auto allowed = isCurrent ? ceramic.currentLimit : ceramic.slewLimit;
    return { isCurrent ? LimitKind::current : LimitKind::slew, static_cast<int> (largest.ceramic),
             largest.time - program.focusTime, largest.share * allowed, allowed };
}

LimitUses sampleUses (const ModalModel& model, const AllocationChoice& choice, const VoltageProgram& program)
{
    const auto& samples = *program.samples;
    LargestShare largest;
    largest.look (samples.values, program.voltageLimits, samples.firstTime,
                  samples.firstTime + static_cast<double> (samples.values.cols() - 1) / samples.playback.sampleRate);
    LimitUses uses { voltageUse (model, choice, program, largest), {} };

    if (const auto slewLimits = antinode::slewLimits (model); slewLimits.maxCoeff() > 0)
    {
        const auto slopes = slopesOf (samples);
        LargestShare steepest;
        steepest.look (slopes.values, slewLimits, slopes.first, slopes.last);
        uses.slew = slewUse (model, program, steepest);
    }

    return uses;
}
} // namespace

LimitKind voltageLimitKind (const ModalModel& model, const AllocationChoice& choice, std::size_t ceramic)
{
    const auto& one = model.ceramics[ceramic];
    const auto isAmplified = one.amplifierVoltage > 0;
    const auto output = isAmplified ? one.amplifierVoltage : model.fullScaleVoltage;
    const auto ofFocus = choice.voltageLimit.value_or (std::numeric_limits<double>::infinity());

    if (one.voltageLimit <= std::min (output, ofFocus))
        return LimitKind::ceramic;

    if (ofFocus <= output)
        return LimitKind::focus;

    return isAmplified ? LimitKind::amplifier : LimitKind::fullScale;
}

ModalModel withoutVoltageLimits (ModalModel model)
{
    model.fullScaleVoltage = noVoltageLimit;

    for (auto& ceramic : model.ceramics)
    {
        ceramic.voltageLimit = noVoltageLimit;
        ceramic.amplifierVoltage = 0;
    }

    return model;
}

LimitUses limitUses (const ModalModel& model, const AllocationChoice& choice, const VoltageProgram& program)
{
    if (program.samples)
        return sampleUses (model, choice, program);

    const ProgramVoltages voltages (program);

    if (program.oscillations.empty())
        return { voltageUse (model, choice, program, {}), {} };

    LimitUses uses { voltageUse (model, choice, program, largestShare (voltages, program.voltageLimits, false)), {} };
    const auto slewLimits = antinode::slewLimits (model);

    if (slewLimits.maxCoeff() > 0)
        uses.slew = slewUse (model, program, largestShare (voltages, slewLimits, true));

    return uses;
}

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
