#include "NoteBank.h"

#include <antinode_documents/Library.h>
#include <antinode_engine/FocusBank.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_focus/SpillOver.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace antinode
{
namespace
{
constexpr double bankMargin = 0.1; // of the surface's shorter side, kept from its edges
} // namespace

int bankPlaceOf (int note, NoteMeaning meaning)
{
    return meaning == NoteMeaning::spotOnly || note == spotNote ? FocusBank::livePlace
                                                                : std::clamp (note, 0, FocusBank::places - 1);
}

double noteAmplitude (double velocity, double level)
{
    constexpr double softest = 1 / 127.0;
    return level > 0 && velocity > 0 ? std::pow (10, -level / 20 * (1 - velocity) / (1 - softest)) : velocity;
}

std::vector<std::pair<double, double>> spreadNotes (const Surface& surface, std::pair<double, double> spot)
{
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto shorter = height > 0 ? std::min (width, height) : width;
    auto places = bankPlaces (surface, FocusBank::notePlaces, bankMargin * shorter);
    places[spotNote] = spot;
    return places;
}

std::function<WideModel()> modesBeyond (std::shared_ptr<const DeviceDocument> device,
                                        std::shared_ptr<const ModalModel> model, double sampleRate)
{
    return [document = std::move (device), known = std::move (model), sampleRate]
    { return widened (document->description, *known, sampleRate, true); };
}

namespace
{
bool contains (std::span<const int> places, int place)
{
    return std::find (places.begin(), places.end(), place) != places.end();
}
} // namespace

BankOrder::BankOrder (const std::vector<int>& wantedFirst, std::size_t count) : first (wantedFirst), left (count)
{
    const auto centre = first.empty() ? 0 : first.front();
    const auto priority = [this] (int place) { return std::find (first.begin(), first.end(), place) - first.begin(); };
    std::iota (left.begin(), left.end(), 0);
    std::stable_sort (left.begin(), left.end(),
                      [centre] (int one, int other) { return std::abs (one - centre) < std::abs (other - centre); });
    std::stable_sort (left.begin(), left.end(), [&] (int one, int other) { return priority (one) < priority (other); });
}

BankOrder::Next BankOrder::take (std::span<const int> urgent)
{
    auto found = std::find_if (left.begin(), left.end(), [urgent] (int place) { return contains (urgent, place); });

    if (found == left.end())
        found = left.begin();

    const auto place = *found;
    left.erase (found);
    return { place, contains (urgent, place) || contains (first, place) };
}
} // namespace antinode
