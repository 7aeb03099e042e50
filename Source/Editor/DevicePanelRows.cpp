#include "DevicePanel.h"

#include "EditorLook.h"

#include <antinode_drafts/DeviceEdits.h>
#include <antinode_structure/Materials.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
using Json = nlohmann::json;

constexpr int mostLayers = 6;

/** Built-in materials by their names, with what scatters between samples. */
struct MaterialWords
{
    std::vector<std::string> names;
    juce::StringArray words;

    template <typename Table>
    void add (const Table& table)
    {
        for (const auto& entry : table)
        {
            names.emplace_back (entry.notes.name);
            words.add (fromUtf8 (std::string (entry.notes.name)) + "   "
                       + fromUtf8 (std::string (entry.notes.scatter)));
        }
    }

    /** -1: none of them. */
    int indexOf (const Json& material) const
    {
        const auto found =
            material.is_string() ? std::find (names.begin(), names.end(), material.get<std::string>()) : names.end();
        return found != names.end() ? static_cast<int> (found - names.begin()) : -1;
    }
};

const MaterialWords& elasticWords()
{
    static const auto words = []
    {
        MaterialWords made;
        made.add (elasticMaterials());
        return made;
    }();
    return words;
}

const MaterialWords& layerWords()
{
    static const auto words = []
    {
        MaterialWords made;
        made.add (elasticMaterials());
        made.add (viscoelasticMaterials());
        return made;
    }();
    return words;
}

const MaterialWords& ceramicWords()
{
    static const auto words = []
    {
        MaterialWords made;
        made.add (piezoelectricMaterials());
        return made;
    }();
    return words;
}

/** Soft layers lie between others. */
const MaterialWords& wordsOf (const Json& device)
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
                                          std::function<void()> action)
{
    buttons.push_back (std::make_unique<juce::TextButton> (name));
    auto& button = *buttons.back();
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
    auto& begins = addButton (section, "New", "Begins a device from a template", {});
    begins.onClick = [this, &begins] { chooseTemplate (begins); };
    addButton (section, "Duplicate", "The same device by another name", [this] { duplicate(); });
    addButton (section, "Save file", "Writes the device as a file that the command line takes",
               [this] { chooseFile(); });
    sections.push_back (std::move (section));
}

void DevicePanel::makeSizes()
{
    Section section { "Size", {}, {} };

    for (const auto i : { 0, 1 })
        addNumber (section,
                   { i == 0 ? "Length" : "Width", "mm", "What lies on the device keeps its share of the size", 5, 1000,
                     150, 0.1,
                     [i] (const Json& device)
                     { return i == 0 || hasTwoSizes (device) ? std::optional (sizeOf (device)[i]) : std::nullopt; },
                     [i] (const Json& device, double value)
                     {
                         auto size = sizeOf (device);
                         size[i] = value;
                         return withSize (device, size);
                     } });

    addNumber (section, { "Q", "", "Quality factor of all modes: glued ceramics and mounting, without the edges'", 2,
                          1000, 50, 1,
                          [] (const Json& device)
                          {
                              const auto value = qualityFactorOf (device);
                              return value > 0 ? std::optional (value) : std::nullopt;
                          },
                          withQualityFactor });
    addNumber (section,
               { "Voltage limit", "V", "Of every ceramic and its amplifier", 1, 1000, 100, 1,
                 [] (const Json& device) { return std::optional (voltageLimitOf (device)); }, withVoltageLimit });
    sections.push_back (std::move (section));
}

void DevicePanel::makeLayers()
{
    Section section { "Thickness and material", {}, {} };

    for (std::size_t i = 0; i < mostLayers; ++i)
    {
        const auto isThere = [i] (const Json& device) { return i < layersOf (device).size(); };
        const auto number = i == 0 ? juce::String() : " " + juce::String (i + 1);
        addNumber (section,
                   { "Thickness" + number, "mm", "Layers count from the bottom up", 0.05, 20, 1.5, 0.01,
                     [i, isThere] (const Json& device)
                     { return isThere (device) ? std::optional (layersOf (device)[i].thickness) : std::nullopt; },
                     [i] (const Json& device, double value)
                     {
                         auto layers = layersOf (device);
                         layers[i].thickness = value;
                         return withLayers (device, layers);
                     } });
        addChoice (section, { "Material" + number, "With what scatters between samples",
                              [] (const Json& device) { return wordsOf (device).words; },
                              [i, isThere] (const Json& device) {
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

    addButton (section, "Add a layer", "One more on top, as the topmost one",
               [this]
               {
                   auto layers = layersOf (draft.document());

                   if (layers.size() < mostLayers && ! isLine (draft.document()))
                   {
                       layers.push_back (layers.back());
                       draft.apply (withLayers (draft.document(), layers));
                   }
                   else if (draft.say)
                       draft.say ("A plate has up to 6 layers here, a beam one");
               });
    addButton (section, "Remove the top", "Without the topmost layer",
               [this]
               {
                   auto layers = layersOf (draft.document());

                   if (layers.size() > 1)
                   {
                       layers.pop_back();
                       draft.apply (withLayers (draft.document(), layers));
                   }
                   else if (draft.say)
                       draft.say ("A device has one layer at least");
               });
    sections.push_back (std::move (section));
}

void DevicePanel::makeEdges()
{
    Section section { "Edges", {}, {} };
    addChoice (section, { "Edge", "Which edge the next rows are about; or click it",
                          [] (const Json& device)
                          {
                              juce::StringArray words { "all" };

                              for (const auto& edge : edgesOf (device))
                                  words.add (fromUtf8 (edge.name));

                              return words;
                          },
                          [this] (const Json& device) -> std::optional<int>
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

    const auto usualOf = [] (const Json& device)
    {
        std::vector<const UsualSupport*> all;

        for (const auto& usual : usualSupports())
            if (isLine (device) ? usual.isOfBeams : usual.isOfPlates)
                all.push_back (&usual);

        return all;
    };
    const auto shownEdge = [this] (const Json& device)
    {
        const auto edges = edgesOf (device);
        return edges.empty() ? std::string() : draft.edge.empty() ? edges.front().name : draft.edge;
    };
    addChoice (section, { "Held by", "What holds the edge; tape, foam and silicone are springs along it",
                          [usualOf] (const Json& device)
                          {
                              juce::StringArray words;

                              for (const auto* const usual : usualOf (device))
                                  words.add (fromUtf8 (usual->name));

                              return words;
                          },
                          [usualOf, shownEdge] (const Json& device) -> std::optional<int>
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
                          [shownEdge] (const Json& device) -> std::optional<double>
                          {
                              const auto edge = shownEdge (device);
                              const auto support = edge.empty() ? Json() : supportOf (device, edge);
                              return usualSupport (support) != nullptr && support.is_object()
                                         ? std::optional (support["stiffness_N_per_mm2"].get<double>())
                                         : std::nullopt;
                          },
                          [this, shownEdge] (const Json& device, double value)
                          {
                              const auto support = supportOf (device, shownEdge (device));
                              return withSupport (device, draft.edge, supportJson (*usualSupport (support), value));
                          } });
    sections.push_back (std::move (section));
}

void DevicePanel::makeCeramics()
{
    Section section { "Ceramics: the selected ones, else all", {}, {} };
    const auto first = [this] (const Json& device) -> std::optional<DrawnCeramic>
    {
        const auto all = ceramicsOf (device);
        const auto index = draft.ceramics.empty() ? std::size_t { 0 } : *draft.ceramics.begin();
        return index < all.size() ? std::optional (all[index]) : std::nullopt;
    };
    const auto withEach = [this] (Json device, const std::function<void (DrawnCeramic&)>& change)
    {
        auto all = ceramicsOf (device);

        for (const auto index : draft.chosenOrAll())
        {
            change (all[index]);
            device = withCeramic (std::move (device), index, all[index]);
        }

        return device;
    };
    addChoice (section, { "Shape", "Of the ceramics",
                          [] (const Json&) {
                              return juce::StringArray { "rectangle", "disc", "ring" };
                          },
                          [first] (const Json& device) -> std::optional<int>
                          {
                              const auto ceramic = first (device);
                              return ceramic && ! isLine (device) ? std::optional (static_cast<int> (ceramic->shape))
                                                                  : std::nullopt;
                          },
                          [this, withEach] (int index)
                          {
                              draft.apply (withEach (draft.document(), [index] (DrawnCeramic& ceramic)
                                                     { ceramic.shape = static_cast<CeramicShape> (index); }));
                          } });

    for (const auto i : { 0, 1 })
        addNumber (section, { i == 0 ? "Size" : "Across", "mm", i == 0 ? "Diameter or length" : "Across the length", 1,
                              200, 15, 0.1,
                              [i, first] (const Json& device) -> std::optional<double>
                              {
                                  const auto ceramic = first (device);
                                  const auto isRound = ceramic && ceramic->shape != CeramicShape::rectangle;
                                  return ceramic && ! (i == 1 && isRound) ? std::optional (ceramic->size[i])
                                                                          : std::nullopt;
                              },
                              [i, withEach] (const Json& device, double value)
                              {
                                  return withEach (device,
                                                   [i, value] (DrawnCeramic& ceramic)
                                                   {
                                                       ceramic.size[i] = value;

                                                       if (ceramic.shape != CeramicShape::rectangle)
                                                           ceramic.size[1 - i] = value;
                                                   });
                              } });

    addNumber (section, { "Angle", fromUtf8 ("\xC2\xB0"), "Counter-clockwise", -180, 180, 0, 1,
                          [first] (const Json& device) -> std::optional<double>
                          {
                              const auto ceramic = first (device);
                              return ceramic && ! isLine (device) && ceramic->shape == CeramicShape::rectangle
                                         ? std::optional (ceramic->angle)
                                         : std::nullopt;
                          },
                          [withEach] (const Json& device, double value)
                          { return withEach (device, [value] (DrawnCeramic& ceramic) { ceramic.angle = value; }); } });

    const auto keyOf = [this] (const Json& device, const char* key) -> Json
    {
        const auto index = draft.ceramics.empty() ? std::size_t { 0 } : *draft.ceramics.begin();
        const auto& all = device["ceramics"];
        return index < all.size() ? all[index].value (key, Json ("")) : Json();
    };
    addNumber (section, { "Thickness, each", "mm", "Of one ceramic", 0.02, 5, 0.4, 0.01,
                          [keyOf] (const Json& device) -> std::optional<double>
                          {
                              const auto value = keyOf (device, "thickness_mm");
                              return value.is_number() ? std::optional (value.get<double>()) : std::nullopt;
                          },
                          [this] (const Json& device, double value)
                          { return withCeramicKey (device, draft.chosenOrAll(), "thickness_mm", value); } });
    addChoice (section, { "Material, each", "With what scatters between samples",
                          [] (const Json&) { return ceramicWords().words; },
                          [keyOf] (const Json& device) -> std::optional<int>
                          {
                              const auto value = keyOf (device, "material");
                              return value.is_null() ? std::nullopt : std::optional (ceramicWords().indexOf (value));
                          },
                          [this] (int index)
                          {
                              draft.apply (withCeramicKey (draft.document(), draft.chosenOrAll(), "material",
                                                           ceramicWords().names[static_cast<std::size_t> (index)]));
                          } });
    addChoice (section, { "Mounting", "One on the back, or a pair on both sides",
                          [] (const Json&) {
                              return juce::StringArray { "one side", "both sides" };
                          },
                          [keyOf] (const Json& device) -> std::optional<int>
                          {
                              const auto value = keyOf (device, "mounting");
                              return value.is_null() ? std::nullopt : std::optional (value == "both_sides" ? 1 : 0);
                          },
                          [this] (int index)
                          {
                              draft.apply (withCeramicKey (draft.document(), draft.chosenOrAll(), "mounting",
                                                           index == 1 ? "both_sides" : "one_side"));
                          } });

    for (const auto isLeftToRight : { true, false })
        addButton (section, fromUtf8 (isLeftToRight ? "Mirror \xE2\x86\x94" : "Mirror \xE2\x86\x95"),
                   isLeftToRight ? "More ceramics, mirrored from left to right"
                                 : "More ceramics, mirrored from below upwards",
                   [this, isLeftToRight]
                   { draft.apply (withMirrored (draft.document(), draft.chosenOrAll(), isLeftToRight)); });

    addButton (section, "Remove", "The selected ceramics, else all. Key on the surface: Delete",
               [this] { draft.removeCeramics (draft.chosenOrAll()); });
    sections.push_back (std::move (section));
}

void DevicePanel::makePlacing()
{
    Section section { "More ceramics, like the selected one", {}, {} };
    addChoice (section, { "Along", "The side along which a row lies",
                          [] (const Json&) {
                              return juce::StringArray { "bottom", "right", "top", "left" };
                          },
                          [this] (const Json& device) -> std::optional<int>
                          { return isLine (device) ? std::nullopt : std::optional (sideOfRow); },
                          [this] (int index) { sideOfRow = index; } });
    addNumber (section, { "Count", "", "How many", 1, 64, 8, 1,
                          [this] (const Json&) { return std::optional<double> (countOfRow); },
                          [this] (const Json& device, double value)
                          {
                              countOfRow = juce::roundToInt (value);
                              return device;
                          } });
    addNumber (section,
               { "From the edge", "mm", "Distance of the ceramics from it", 0, 100, 10, 0.5,
                 [this] (const Json& device) { return isLine (device) ? std::nullopt : std::optional (distanceOfRow); },
                 [this] (const Json& device, double value)
                 {
                     distanceOfRow = value;
                     return device;
                 } });
    const auto like = [this] { return draft.ceramics.empty() ? std::size_t { 0 } : *draft.ceramics.begin(); };
    const auto kind = [this, like]
    {
        const auto& device = draft.document();
        const auto all = ceramicsOf (device);
        constexpr double usual = 12; // mm
        return like() < all.size() ? all[like()]
                                   : DrawnCeramic { isLine (device) ? CeramicShape::rectangle : CeramicShape::disc,
                                                    { 0, 0 },
                                                    { usual, isLine (device) ? sizeOf (device).y() : usual } };
    };
    addButton (section, "Add one", "In the middle of the device",
               [this, like, kind]
               {
                   auto more = kind();
                   const auto extent = extentOf (outlineOf (draft.document()));
                   more.centre = 500 * (extent.least + extent.largest);
                   draft.apply (withMoreCeramic (draft.document(), more, like()));
               });
    addButton (section, "Add a row", "Evenly along the side",
               [this, like, kind]
               {
                   draft.apply (withRow (draft.document(), kind(), like(), static_cast<DeviceSide> (sideOfRow),
                                         countOfRow, distanceOfRow));
               });
    addButton (section, "Add a ring", "Evenly around the middle",
               [this, like, kind]
               { draft.apply (withRing (draft.document(), kind(), like(), countOfRow, distanceOfRow)); });
    sections.push_back (std::move (section));
}

void DevicePanel::makeSearch()
{
    Section section { "Better places for the ceramics", {}, {} };
    searchText.setFont (EditorLook::font (EditorLook::smallTextHeight));
    searchText.setBorderSize ({});
    searchText.setMinimumHorizontalScale (0.7f);
    searchText.setTitle ("Search of places");
    page.addChildComponent (searchText);
    section.rows.push_back (&searchText);
    searchButton = &addButton (section, "Place for me",
                               "Searches the places from which the ceramics reach the present focus with least voltage",
                               [this] { onPlace (! search.isRunning); });
    takeButton =
        &addButton (section, "Take these", "Puts the ceramics at the places that were found", [this] { takePlaces(); });
    sections.push_back (std::move (section));
}

void DevicePanel::takePlaces()
{
    std::vector<Eigen::Vector2d> places;

    for (const auto& ceramic : search.ceramics)
        places.push_back (1000 * ceramic.centre());

    if (! places.empty())
        draft.apply (withPlaces (draft.document(), places));
}

/** What was found for another device is void. */
void DevicePanel::showSearch (const PlaceProgress& searched)
{
    const auto hadPlaces = ! search.ceramics.empty();
    search = searched;

    if (search.device != draft.device())
        search = {};

    const auto volts = [] (double value)
    { return std::isfinite (value) ? juce::String (juce::roundToInt (value)) + " V" : juce::String ("out of reach"); };
    searchButton->setButtonText (search.isRunning ? "Stop" : "Place for me");
    searchText.setText (search.isRunning ? "Searching: " + juce::String (juce::roundToInt (100 * search.share)) + " %"
                        : ! search.ceramics.empty()
                            ? fromUtf8 ("\xE2\x89\x88 ") + volts (search.voltsNow) + " today, "
                                  + fromUtf8 ("\xE2\x89\x88 ") + volts (search.voltsThere) + " there"
                            : fromUtf8 (search.error),
                        juce::dontSendNotification);

    if (hadPlaces != ! search.ceramics.empty())
        seenChange = -1; // Lays the buttons out.
}

void DevicePanel::addPoint (double stiffness, double mass)
{
    if (isLine (draft.document()))
    {
        if (draft.say)
            draft.say ("Feet and masses are those of plates");

        return;
    }

    const auto extent = extentOf (outlineOf (draft.document()));
    draft.apply (withPoint (draft.document(), pointsOf (draft.document()).size(),
                            { 500 * (extent.least + extent.largest), stiffness, mass }));
}

void DevicePanel::makePoints()
{
    Section section { "Feet and masses", {}, {} };
    const auto point = [this] (const Json& device) -> std::optional<DrawnPoint>
    {
        const auto all = pointsOf (device);
        return draft.point && *draft.point < all.size() ? std::optional (all[*draft.point]) : std::nullopt;
    };

    for (const auto isMass : { false, true })
        addNumber (section, { isMass ? "Mass" : "Foot", isMass ? "g" : "N/mm",
                              isMass ? "Of the selected one" : "Stiffness of the selected one", 0.01, 1000, 20, 0,
                              [isMass, point] (const Json& device) -> std::optional<double>
                              {
                                  const auto chosen = point (device);
                                  const auto value = chosen ? isMass ? chosen->mass : chosen->stiffness : 0;
                                  return value > 0 ? std::optional (value) : std::nullopt;
                              },
                              [this, isMass, point] (const Json& device, double value)
                              {
                                  auto changed = *point (device);
                                  (isMass ? changed.mass : changed.stiffness) = value;
                                  return withPoint (device, *draft.point, changed);
                              } });

    constexpr double usualStiffness = 20, usualMass = 10;
    addButton (section, "Add a foot", "In the middle, to be dragged; a right click adds it where it is wanted",
               [this] { addPoint (usualStiffness, 0); });
    addButton (section, "Add a mass", "In the middle, to be dragged; a right click adds it where it is wanted",
               [this] { addPoint (0, usualMass); });
    sections.push_back (std::move (section));
}
} // namespace antinode
