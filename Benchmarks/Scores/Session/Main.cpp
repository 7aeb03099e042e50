// What places of a bank of samples cost, and how soon the first follows a limit that moves:
// Docs/Design/allocation.md.
//
//     antinode_bank_scores device focus [places [limit in V...]]

#include <antinode_documents/Inputs.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_session/DesignWorker.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace
{
using namespace antinode;

struct Cost
{
    double wall = 0, cpu = 0; // ms
    FocusDesign design;
};

Cost designed (PlaceDesigner& designer, const DesignRequest& request, const FocusDescription& focus)
{
    const auto begin = std::chrono::steady_clock::now();
    const auto processor = std::clock();
    auto design = designer.design (request, focus);
    return { std::chrono::duration<double, std::milli> (std::chrono::steady_clock::now() - begin).count(),
             1e3 * static_cast<double> (std::clock() - processor) / CLOCKS_PER_SEC, std::move (design) };
}

void print (const std::string& what, const Cost& cost, const WideModel& wide)
{
    std::printf ("| %s | %.0f | %.0f | %.2f | %.3f |\n", what.c_str(), cost.wall, cost.cpu, peakVoltage (cost.design),
                 100 * spillOverShare (wide, cost.design));
    std::fflush (stdout);
}
} // namespace

int main (int count, char** arguments)
{
    const std::vector<std::string> given (arguments + 1, arguments + count);
    const auto description = loadDevice (given.at (0), {});
    const auto model = std::make_shared<const ModalModel> (solveDevice (description, {}, true));
    const Playback playback { Reconstruction::bandLimited, 48000 };
    const auto wide = solveWide (description, *model, frequencyBeyond (*model, playback.sampleRate), true);
    auto focus = loadFocus (given.at (1), { "focus.allocation.method=least_voltage" });
    const auto places = bankPlaces (model->surface, given.size() > 2 ? std::atoi (given[2].c_str()) : 16, 0.015);
    PlaceDesigner designer;
    const DesignRequest request { model, focus, places, {}, playback, [&] { return wide; } };
    std::printf ("| design | ms | ms of CPU | V | spill-over, %% |\n|---|---|---|---|---|\n");
    designer.begin (request);
    print ("first", designed (designer, request, focus), wide);
    std::vector<double> cpu, shares;

    for (const auto& [x, y] : places)
    {
        const auto cost = designed (designer, request, movedTo (focus, x, y));
        cpu.push_back (cost.cpu);
        shares.push_back (100 * spillOverShare (wide, cost.design));
    }

    std::printf ("%zu places: %.0f ms of CPU each (median), %.0f at most; spill-over %.3f %% (median), %.3f at most\n",
                 places.size(), median (cpu), *std::max_element (cpu.begin(), cpu.end()), median (shares),
                 *std::max_element (shares.begin(), shares.end()));

    for (std::size_t i = 3; i < given.size(); ++i)
    {
        auto limited = request;
        limited.focus.allocation.voltageLimit = std::atof (given[i].c_str());
        designer.begin (limited);

        try
        {
            print ("limit " + given[i] + " V", designed (designer, limited, limited.focus), wide);
        }
        catch (const LimitError& error)
        {
            std::printf ("| limit %s V | %s |\n", given[i].c_str(), error.what());
        }
    }
}
