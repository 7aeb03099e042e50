#include "AlglibPeer.h"
#include "Allocation/AllocationInstances.h"
#include "ClpPeer.h"
#include "IpoptPeer.h"
#include "NloptPeer.h"
#include "OwnTable.h"
#include "ReferenceLoop.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

namespace antinode::bench
{
namespace
{
constexpr auto tolerance = 1e-8;
constexpr auto slack = 1.05;

/** A general solver and the largest of the sizes s1, s2 ... that it is given. */
struct Peer
{
    const char* name;
    int largestSize;
    std::function<PeerResult (const PeerProblem&, double)> solve;
};

const Peer normPeers[] = { { "Ipopt", 4, solveByIpopt },
                           { "ALGLIB", 3, solveByAlglib },
                           { "NLopt SLSQP", 1, solveByNlopt } };
const Peer peakPeers[] = { { "Clp", 3, minimumPeakByClp } };

double secondsSince (std::clock_t begin)
{
    return static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
}

/** Our time, the least of several runs, and the answer. */
std::pair<double, Allocation> ours (const AllocationProblem& problem, AllocationGoal goal)
{
    constexpr auto runs = 3;
    auto minimum = 1e9;
    Allocation allocation;

    for (int n = 0; n < runs; ++n)
    {
        const auto begin = std::clock();
        allocation = solveAllocation (problem, goal);
        minimum = std::min (minimum, secondsSince (begin));
    }

    return { minimum, allocation };
}

void printOurs (int size, const char* what, double seconds, double gap)
{
    std::printf ("| s%d | %s | Antinode | %.3g | %.3g | 1 | %.1e | |\n", size, what, 1000 * seconds,
                 seconds / referenceSeconds(), gap);
}

void printPeer (int size, const char* what, const char* name, const PeerResult& result, double ourSeconds,
                double excess, const PeerQuality& quality)
{
    std::printf ("| s%d | %s | %s | %.3g | %.3g | %.3g | %.1e | %.1e%s |\n", size, what, name, 1000 * result.seconds,
                 result.seconds / referenceSeconds(), result.seconds / ourSeconds, excess,
                 std::max (quality.peakRatio - 1, quality.rowError), result.hasEnded ? "" : ", not ended");
    std::fflush (stdout);
}

void compareNorm (int size, const AllocationProblem& problem)
{
    const PeerProblem written (problem);
    const auto [seconds, allocation] = ours (problem, AllocationGoal::norm);
    const auto volts = written.whitened.voltageUnit * written.whitened.voltageUnit;
    printOurs (size, "least norm", seconds, allocation.certificate.gap);

    for (const auto& peer : normPeers)
    {
        if (size > peer.largestSize)
            continue;

        const auto result = peer.solve (written, tolerance);
        const auto quality = assessQuality (written, result.x);
        printPeer (size, "least norm", peer.name, result, seconds,
                   quality.objective * volts / allocation.certificate.objective - 1, quality);
    }
}

void comparePeak (int size, const AllocationProblem& problem)
{
    const PeerProblem written (problem);
    const auto [seconds, allocation] = ours (problem, AllocationGoal::peak);
    const auto minimum = allocation.certificate.minimumPeakRatio;
    printOurs (size, "least peak", seconds, allocation.certificate.gap);

    for (const auto& peer : peakPeers)
    {
        if (size > peer.largestSize)
            continue;

        const auto result = peer.solve (written, tolerance);
        auto quality = assessQuality (written, result.x.head (written.unknowns()));
        const auto excess = quality.peakRatio / minimum - 1;
        quality.peakRatio = 1;
        printPeer (size, "least peak", peer.name, result, seconds, excess, quality);
    }
}

void compare (int largest)
{
    std::puts ("| size | goal | solver | ms | reference loops | times ours | gap, or above ours | broken by |");
    std::puts ("|---|---|---|---|---|---|---|---|");

    for (int size = 1; size <= largest; ++size)
    {
        const auto problem =
            test::instance (test::ModePattern::plate, test::RowKind::terminal, test::standardSizes[size - 1], 1);
        const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
        compareNorm (size, test::withLimits (problem, slack, minimum));
        comparePeak (size, problem);
    }
}
} // namespace
} // namespace antinode::bench

/** Processor time of one thread, as tables. `antinode_solver_peers peers 4`: the same instances up to s4, solved by
   Antinode and by general solvers. `antinode_solver_peers own 6`: Antinode alone on all kinds of instances up to s6. */
int main (int count, char** arguments)
{
    const std::string what = count == 3 ? arguments[1] : "";
    const auto largest = count == 3 ? std::atoi (arguments[2]) : 0;

    if ((what != "peers" && what != "own") || largest < 1 || largest > 6)
    {
        std::fputs ("usage: antinode_solver_peers peers|own SIZE, with a largest size of 1 to 6\n", stderr);
        return 2;
    }

    if (what == "peers")
        antinode::bench::compare (largest);
    else
        antinode::bench::printOwnTable (largest);

    return 0;
}
