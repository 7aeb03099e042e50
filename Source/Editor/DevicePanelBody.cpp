#include "DevicePanel.h"

#include "EditorLook.h"

#include <antinode_drafts/DeviceEdits.h>
#include <antinode_structure/Materials.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int mostLayers = 6;

const MaterialWords& elasticWords()
{
    static const MaterialWords words (elasticMaterials());
    return words;
}

const MaterialWords& layerWords()
{
    static const MaterialWords words (elasticMaterials(), viscoelasticMaterials());
    return words;
}

/** Soft layers lie between others. */
const MaterialWords& wordsOf (const nlohmann::json& device)
{
    return layersOf (device).size() > 1 ? layerWords() : elasticWords();
}
} // namespace

void DevicePanel::addNumber (Section& section, DraftNumber::Kind kind)
{
    rows.push_back (std::make_unique<DraftNumber> (draft, std::move (kind)));
    page.addChildComponent (*rows.back());
    section.rows.push_back (rows.back().get());
}

void DevicePanel::addChoice (Section& section, DraftChoice::Kind kind)
{
    rows.push_back (std::make_unique<DraftChoice> (draft, std::move (kind)));
    page.addChildComponent (*rows.back());
    section.rows.push_back (rows.back().get());
}

juce::TextButton& DevicePanel::addButton (Section& section, const juce::String& name, const juce::String& tooltip,
                                          std::function<void()> action, std::function<bool()> isThere)
{
    offers.push_back ({ std::make_unique<juce::TextButton> (name), std::move (isThere) });
    auto& button = *offers.back().button;
    button.setTooltip (tooltip);
    button.onClick = std::move (action);
    page.addChildComponent (button);
    section.buttons.push_back (&button);
    return button;
}

void DevicePanel::makeDevice()
{
    Section section;
    deviceName.setEditable (false, true);
    deviceName.setTitle ("Name of the device");
    deviceName.setTooltip ("Name of the device. A double click changes it");
    deviceName.setFont (EditorLook::font (15, true));
    deviceName.onTextChange = [this] { draft.apply (withName (draft.document(), deviceName.getText().toStdString())); };
    page.addAndMakeVisible (deviceName);
    section.rows.push_back (&deviceName);
    auto& begins = addButton (section, "New", "Begins a device from a template", {}, [] { return true; });
    begins.onClick = [this, &begins] { chooseTemplate (begins); };
    addButton (
        section, "Duplicate", "The same device by another name", [this] { duplicate(); },
        [this] { return draft.isDrawn(); });
    addButton (
        section, "Save file", "Writes the device as a file that the command line takes", [this] { chooseFile(); },
        [this] { return draft.isDrawn(); });
    sections.push_back (std::move (section));
}

void DevicePanel::makeSizes()
{
    Section section { "Size", {}, {} };

    for (const auto i : { 0, 1 })
        addNumber (section,
                   { i == 0 ? "Length" : "Width", "mm", "What lies on the device keeps its share of the size", 5, 1000,
                     150, 0.1,
                     [i] (const nlohmann::json& device)
                     { return i == 0 || hasTwoSizes (device) ? std::optional (sizeOf (device)[i]) : std::nullopt; },
                     [i] (const nlohmann::json& device, double value)
                     {
                         auto size = sizeOf (device);
                         size[i] = value;
                         return withSize (device, size);
                     } });

    addNumber (section, { "Legs", "mm", "Length of the legs of a staple", 1, 200, 20, 0.1,
                          [] (const nlohmann::json& device) {
                              return device.contains ("leg_length_mm")
                                         ? std::optional (device["leg_length_mm"].get<double>())
                                         : std::nullopt;
                          },
                          [] (nlohmann::json device, double value)
                          {
                              device["leg_length_mm"] = value;
                              return device;
                          } });
    addNumber (section, { "Q", "", "Quality factor of all modes: glued ceramics and mounting, without the edges'", 2,
                          1000, 50, 1,
                          [] (const nlohmann::json& device)
                          {
                              const auto value = qualityFactorOf (device);
                              return value > 0 ? std::optional (value) : std::nullopt;
                          },
                          withQualityFactor });
    addNumber (section, { "Voltage limit", "V", "Of every ceramic and its amplifier", 1, 1000, 100, 1,
                          [] (const nlohmann::json& device) { return std::optional (voltageLimitOf (device)); },
                          withVoltageLimit });
    sections.push_back (std::move (section));
}

void DevicePanel::makeLayers()
{
    Section section { "Thickness and material", {}, {} };

    for (std::size_t i = 0; i < mostLayers; ++i)
    {
        const auto isThere = [i] (const nlohmann::json& device) { return i < layersOf (device).size(); };
        const auto number = i == 0 ? juce::String() : " " + juce::String (i + 1);
        addNumber (section,
                   { "Thickness" + number, "mm", "Layers count from the bottom up", 0.05, 20, 1.5, 0.01,
                     [i, isThere] (const nlohmann::json& device)
                     { return isThere (device) ? std::optional (layersOf (device)[i].thickness) : std::nullopt; },
                     [i] (const nlohmann::json& device, double value)
                     {
                         auto layers = layersOf (device);
                         layers[i].thickness = value;
                         return withLayers (device, layers);
                     } });
        addChoice (section, { "Material" + number, "With what scatters between samples",
                              [] (const nlohmann::json& device) { return wordsOf (device).words; },
                              [i, isThere] (const nlohmann::json& device) {
                                  return isThere (device)
                                             ? std::optional (wordsOf (device).indexOf (layersOf (device)[i].material))
                                             : std::nullopt;
                              },
                              [this, i] (int index)
                              {
                                  auto layers = layersOf (draft.document());
                                  layers[i].material =
                                      wordsOf (draft.document()).names[static_cast<std::size_t> (index)];
                                  draft.apply (withLayers (draft.document(), layers));
                              } });
    }

    addButton (
        section, "Add a layer", "One more on top, as the topmost one",
        [this]
        {
            auto layers = layersOf (draft.document());
            layers.push_back (layers.back());
            draft.apply (withLayers (draft.document(), layers));
        },
        [this] { return isOfPlate() && layersOf (draft.document()).size() < mostLayers; });
    addButton (
        section, "Remove the top", "Without the topmost layer",
        [this]
        {
            auto layers = layersOf (draft.document());
            layers.pop_back();
            draft.apply (withLayers (draft.document(), layers));
        },
        [this] { return draft.isDrawn() && layersOf (draft.document()).size() > 1; });
    sections.push_back (std::move (section));
}

void DevicePanel::makeEdges()
{
    Section section { "Edges", {}, {} };
    addChoice (section, { "Edge", "Which edge the next rows are about; or click it",
                          [] (const nlohmann::json& device)
                          {
                              juce::StringArray words { "all" };

                              for (const auto& edge : edgesOf (device))
                                  words.add (fromUtf8 (edge.name));

                              return words;
                          },
                          [this] (const nlohmann::json& device) -> std::optional<int>
                          {
                              const auto edges = edgesOf (device);

                              if (edges.empty())
                                  return std::nullopt;

                              const auto found = std::find_if (edges.begin(), edges.end(),
                                                               [this] (const auto& e) { return e.name == draft.edge; });
                              return found == edges.end() ? 0 : static_cast<int> (found - edges.begin()) + 1;
                          },
                          [this] (int index)
                          {
                              const auto edges = edgesOf (draft.document());
                              draft.edge = index == 0 ? "" : edges[static_cast<std::size_t> (index - 1)].name;
                          } });
    addSupports (section);
    sections.push_back (std::move (section));
}

void DevicePanel::addSupports (Section& section)
{
    const auto usualOf = [] (const nlohmann::json& device)
    {
        std::vector<const UsualSupport*> all;

        for (const auto& usual : usualSupports())
            if (isLine (device) ? usual.isOfBeams : usual.isOfPlates)
                all.push_back (&usual);

        return all;
    };
    const auto shownEdge = [this] (const nlohmann::json& device)
    {
        const auto edges = edgesOf (device);
        return edges.empty() ? std::string() : draft.edge.empty() ? edges.front().name : draft.edge;
    };
    addChoice (section, { "Held by", "What holds the edge; tape, foam and silicone are springs along it",
                          [usualOf] (const nlohmann::json& device)
                          {
                              juce::StringArray words;

                              for (const auto* const usual : usualOf (device))
                                  words.add (fromUtf8 (usual->name));

                              return words;
                          },
                          [usualOf, shownEdge] (const nlohmann::json& device) -> std::optional<int>
                          {
                              const auto edge = shownEdge (device);

                              if (edge.empty())
                                  return std::nullopt;

                              const auto all = usualOf (device);
                              const auto found =
                                  std::find (all.begin(), all.end(), usualSupport (supportOf (device, edge)));
                              return found == all.end() ? -1 : static_cast<int> (found - all.begin());
                          },
                          [this, usualOf] (int index)
                          {
                              const auto& usual = *usualOf (draft.document())[static_cast<std::size_t> (index)];
                              draft.apply (withSupport (draft.document(), draft.edge, supportJson (usual)));
                          } });
    addNumber (section, { "Stiffness", fromUtf8 ("N/mm\xC2\xB2"),
                          "Per length of the edge: modulus times width over thickness of the strip", 0.01, 1000, 5, 0,
                          [shownEdge] (const nlohmann::json& device) -> std::optional<double>
                          {
                              const auto edge = shownEdge (device);
                              const auto support = edge.empty() ? nlohmann::json() : supportOf (device, edge);
                              return usualSupport (support) != nullptr && support.is_object()
                                         ? std::optional (support["stiffness_N_per_mm2"].get<double>())
                                         : std::nullopt;
                          },
                          [this, shownEdge] (const nlohmann::json& device, double value)
                          {
                              const auto support = supportOf (device, shownEdge (device));
                              return withSupport (device, draft.edge, supportJson (*usualSupport (support), value));
                          } });
}
} // namespace antinode
