#include "NoteBank.h"

#include <antinode_documents/Library.h>
#include <antinode_engine/FocusBank.h>
#include <antinode_focus/BankPlaces.h>
#include <antinode_focus/WideDesign.h>

#include <algorithm>

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
} // namespace antinode
