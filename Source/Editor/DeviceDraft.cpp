#include "DeviceDraft.h"

#include "EditorLook.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/OutlineReader.h>
#include <antinode_drafts/DeviceEdits.h>
#include <antinode_outline/Drawing.h>
#include <antinode_session/Documents.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto drawnSource = "device";

/** The mutes of the ceramics that are left. */
std::uint64_t mutesWithout (std::uint64_t mutes, const CeramicChoice& removed)
{
    for (auto index = removed.rbegin(); index != removed.rend(); ++index)
        if (*index < 64)
        {
            const auto below = (std::uint64_t { 1 } << *index) - 1;
            mutes = (mutes & below) | ((mutes >> 1U) & ~below);
        }

    return mutes;
}
} // namespace

DeviceDraft::DeviceDraft (AntinodeProcessor& processorToEdit, History& historyToKeep)
    : processor (processorToEdit), history (historyToKeep)
{
    refresh();
}

bool DeviceDraft::isDrawn() const
{
    return antinode::isDrawn (shown);
}

void DeviceDraft::refresh()
{
    auto now = processor.device();

    if (now == loaded)
        return;

    loaded = read = std::move (now);
    ++changeCount;
    before = nullptr;
    shown = nlohmann::json::parse (loaded->text);
    found = isDrawn() ? ceramicFaults (shown) : std::vector<CeramicFault>();
    const auto count = isDrawn() ? shown["ceramics"].size() : 0;
    std::erase_if (ceramics, [count] (auto index) { return index >= count; });

    if (point && *point >= pointsOf (shown).size())
        point.reset();

    if (! edge.empty())
    {
        const auto edges = isDrawn() ? edgesOf (shown) : std::vector<DrawnEdge>();

        if (std::none_of (edges.begin(), edges.end(), [this] (const auto& each) { return each.name == edge; }))
            edge.clear();
    }
}

juce::String DeviceDraft::tryTo (const std::function<void()>& action)
{
    juce::String failure;

    try
    {
        action();
    }
    catch (const std::exception& error)
    {
        failure = fromUtf8 (error.what());
    }

    if (say)
        say (failure);

    return failure;
}

void DeviceDraft::show (nlohmann::json edited)
{
    shown = std::move (edited);
    ++changeCount;

    try
    {
        found = ceramicFaults (shown);
        read = std::make_shared<const DeviceDocument> (readDeviceDocument (shown, drawnSource));
    }
    catch (const InputError&)
    {
        // The last one that was right is solved until it is dropped.
    }
}

void DeviceDraft::drag (nlohmann::json edited)
{
    if (before == nullptr)
        before = std::make_shared<const nlohmann::json> (shown);

    show (std::move (edited));
}

void DeviceDraft::drop()
{
    if (before == nullptr)
        return;

    const auto edited = shown;
    cancel();
    apply (edited);
}

void DeviceDraft::cancel()
{
    if (before != nullptr)
        show (*std::exchange (before, nullptr));
}

/** @return  why it cannot be */
juce::String DeviceDraft::take (const nlohmann::json& edited)
{
    return tryTo (
        [&]
        {
            auto device = std::make_shared<const DeviceDocument> (readDeviceDocument (edited, drawnSource));

            for (const auto& fault : ceramicFaults (edited))
                if (fault.isForbidden)
                    throw InputError (drawnSource, fault.sentence + "; ceramics lie on it and may only touch");

            if (device->text != loaded->text)
                load (std::move (device), processor.mutes());
        });
}

/** Not as another device: its focus, and all that is set, stay. */
void DeviceDraft::load (std::shared_ptr<const DeviceDocument> device, std::uint64_t mutes)
{
    history.record (
        [&]
        {
            auto wanted = processor.state();
            wanted.device = std::move (device);
            wanted.mutes = mutes;
            processor.setState (wanted, true);
        });
    refresh();
}

void DeviceDraft::apply (const nlohmann::json& edited)
{
    before = nullptr;
    take (edited);

    if (shown != edited || read != loaded)
    {
        loaded = nullptr; // What was dragged is not what is loaded.
        refresh();
    }
}

void DeviceDraft::begin (const nlohmann::json& device)
{
    tryTo (
        [&]
        {
            const auto document = std::make_shared<const DeviceDocument> (readDeviceDocument (device, drawnSource));
            history.record ([&] { processor.load (document, nullptr); });
        });
    ceramics.clear();
    refresh();
}

void DeviceDraft::removeCeramics (const CeramicChoice& removed)
{
    tryTo (
        [&]
        {
            load (std::make_shared<const DeviceDocument> (
                      readDeviceDocument (withoutCeramics (shown, removed), drawnSource)),
                  mutesWithout (processor.mutes(), removed));
            ceramics.clear();
        });
}

void DeviceDraft::takeOutline (const std::string& file)
{
    auto removed = CeramicChoice();
    auto edited = shown;
    const auto failure = tryTo (
        [&]
        {
            if (isLine (shown) || ! isDrawn())
                throw InputError (drawnSource, "is no plate; allowed: the outline of a plate, so begin a new one");

            edited = withOutline (shown, outlineToJson (readOutlineFile (file, {})));

            for (const auto& fault : ceramicFaults (edited))
                if (fault.isForbidden)
                    removed.insert (fault.ceramic);

            edited = withoutCeramics (std::move (edited), removed);
            const auto outline = outlineOf (edited);

            for (auto i = pointsOf (edited).size(); i-- > 0;)
                if (const Eigen::Vector2d place = pointsOf (edited)[i].place / 1000;
                    ! outline.contains (place.x(), place.y()))
                    edited = withoutPoint (std::move (edited), i);

            load (std::make_shared<const DeviceDocument> (readDeviceDocument (edited, drawnSource)),
                  mutesWithout (processor.mutes(), removed));
        });

    if (failure.isEmpty() && ! removed.empty() && say)
        say (juce::String (removed.size()) + " ceramics lay outside of the new outline and were removed");
}

CeramicChoice DeviceDraft::chosenOrAll() const
{
    auto chosen = ceramics;

    if (chosen.empty())
        for (std::size_t i = 0; i < shown["ceramics"].size(); ++i)
            chosen.insert (i);

    return chosen;
}
} // namespace antinode
