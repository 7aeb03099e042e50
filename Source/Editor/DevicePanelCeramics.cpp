#include "DevicePanel.h"

#include "EditorLook.h"

#include <antinode_drafts/DeviceEdits.h>
#include <antinode_structure/Materials.h>

#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
const MaterialWords& ceramicMaterials()
{
    static const MaterialWords words (piezoelectricMaterials());
    return words;
}
} // namespace

void DevicePanel::makeCeramics()
{
    Section section { "Ceramics: the selected ones, else all", {}, {} };
    addCeramicShape (section);
    addCeramicKeys (section);

    for (const auto isLeftToRight : { true, false })
        addButton (
            section, fromUtf8 (isLeftToRight ? "Mirror \xE2\x86\x94" : "Mirror \xE2\x86\x95"),
            isLeftToRight ? "More ceramics, mirrored from left to right" : "More ceramics, mirrored from below upwards",
            [this, isLeftToRight]
            { draft.apply (withMirrored (draft.document(), draft.chosenOrAll(), isLeftToRight)); },
            [this, isLeftToRight] { return hasCeramics() && (isLeftToRight || isOfPlate()); });

    addButton (
        section, "Remove", "The selected ceramics, else all. Key on the surface: Delete",
        [this] { draft.removeCeramics (draft.chosenOrAll()); }, [this] { return hasCeramics(); });
    sections.push_back (std::move (section));
}

void DevicePanel::addCeramicShape (Section& section)
{
    const auto first = [this] (const nlohmann::json& device) -> std::optional<DrawnCeramic>
    {
        const auto all = ceramicsOf (device);
        const auto index = draft.ceramics.empty() ? std::size_t { 0 } : *draft.ceramics.begin();
        return index < all.size() ? std::optional (all[index]) : std::nullopt;
    };
    const auto withEach = [this] (nlohmann::json device, const std::function<void (DrawnCeramic&)>& change)
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
                          [] (const nlohmann::json&) {
                              return juce::StringArray { "rectangle", "disc", "ring" };
                          },
                          [first] (const nlohmann::json& device) -> std::optional<int>
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
                              [i, first] (const nlohmann::json& device) -> std::optional<double>
                              {
                                  const auto ceramic = first (device);
                                  const auto isRound = ceramic && ceramic->shape != CeramicShape::rectangle;
                                  return ceramic && ! (i == 1 && isRound) ? std::optional (ceramic->size[i])
                                                                          : std::nullopt;
                              },
                              [i, withEach] (const nlohmann::json& device, double value)
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
                          [first] (const nlohmann::json& device) -> std::optional<double>
                          {
                              const auto ceramic = first (device);
                              return ceramic && ! isLine (device) && ceramic->shape == CeramicShape::rectangle
                                         ? std::optional (ceramic->angle)
                                         : std::nullopt;
                          },
                          [withEach] (const nlohmann::json& device, double value)
                          { return withEach (device, [value] (DrawnCeramic& ceramic) { ceramic.angle = value; }); } });
}

void DevicePanel::addCeramicKeys (Section& section)
{
    const auto keyOf = [this] (const nlohmann::json& device, const char* key) -> nlohmann::json
    {
        const auto index = draft.ceramics.empty() ? std::size_t { 0 } : *draft.ceramics.begin();
        const auto& all = device["ceramics"];
        return index < all.size() ? all[index].value (key, nlohmann::json ("")) : nlohmann::json();
    };
    addNumber (section, { "Thickness, each", "mm", "Of one ceramic", 0.02, 5, 0.4, 0.01,
                          [keyOf] (const nlohmann::json& device) -> std::optional<double>
                          {
                              const auto value = keyOf (device, "thickness_mm");
                              return value.is_number() ? std::optional (value.get<double>()) : std::nullopt;
                          },
                          [this] (const nlohmann::json& device, double value)
                          { return withCeramicKey (device, draft.chosenOrAll(), "thickness_mm", value); } });
    addChoice (section, { "Material, each", "With what scatters between samples",
                          [] (const nlohmann::json&) { return ceramicMaterials().words; },
                          [keyOf] (const nlohmann::json& device) -> std::optional<int>
                          {
                              const auto value = keyOf (device, "material");
                              return value.is_null() ? std::nullopt
                                                     : std::optional (ceramicMaterials().indexOf (value));
                          },
                          [this] (int index)
                          {
                              draft.apply (withCeramicKey (draft.document(), draft.chosenOrAll(), "material",
                                                           ceramicMaterials().names[static_cast<std::size_t> (index)]));
                          } });
    addChoice (section, { "Mounting", "One on the back, or a pair on both sides",
                          [] (const nlohmann::json&) {
                              return juce::StringArray { "one side", "both sides" };
                          },
                          [keyOf] (const nlohmann::json& device) -> std::optional<int>
                          {
                              const auto value = keyOf (device, "mounting");
                              return value.is_null() ? std::nullopt : std::optional (value == "both_sides" ? 1 : 0);
                          },
                          [this] (int index)
                          {
                              draft.apply (withCeramicKey (draft.document(), draft.chosenOrAll(), "mounting",
                                                           index == 1 ? "both_sides" : "one_side"));
                          } });
}

void DevicePanel::makePlacing()
{
    Section section { "More ceramics, like the selected one", {}, {} };
    addChoice (section, { "Along", "The side along which a row lies",
                          [] (const nlohmann::json&) {
                              return juce::StringArray { "bottom", "right", "top", "left" };
                          },
                          [this] (const nlohmann::json& device) -> std::optional<int>
                          { return isLine (device) ? std::nullopt : std::optional (sideOfRow); },
                          [this] (int index) { sideOfRow = index; } });
    addNumber (section, { "Count", "", "How many", 1, 64, 8, 1,
                          [this] (const nlohmann::json&) { return std::optional<double> (countOfRow); },
                          [this] (const nlohmann::json& device, double value)
                          {
                              countOfRow = juce::roundToInt (value);
                              return device;
                          } });
    addNumber (section, { "From the edge", "mm", "Distance of the ceramics from it", 0, 100, 10, 0.5,
                          [this] (const nlohmann::json& device)
                          { return isLine (device) ? std::nullopt : std::optional (distanceOfRow); },
                          [this] (const nlohmann::json& device, double value)
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
    addButton (
        section, "Add one", "In the middle of the device",
        [this, like, kind]
        {
            auto more = kind();
            const auto extent = extentOf (outlineOf (draft.document()));
            more.centre = 500 * (extent.least + extent.largest);
            draft.apply (withMoreCeramic (draft.document(), more, like()));
        },
        [this] { return draft.isDrawn(); });
    addButton (
        section, "Add a row", "Evenly along the side",
        [this, like, kind]
        {
            draft.apply (withRow (draft.document(), kind(), like(), static_cast<DeviceSide> (sideOfRow), countOfRow,
                                  distanceOfRow));
        },
        [this] { return draft.isDrawn(); });
    addButton (
        section, "Add a ring", "Evenly around the middle",
        [this, like, kind] { draft.apply (withRing (draft.document(), kind(), like(), countOfRow, distanceOfRow)); },
        [this] { return isOfPlate(); });
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
    searchButton = &addButton (
        section, "Place for me",
        "Searches the places from which the ceramics reach the present focus with least voltage",
        [this] { onPlace (! search.isRunning); }, [this] { return hasCeramics(); });
    addButton (
        section, "Take these", "Puts the ceramics at the places that were found", [this] { takePlaces(); },
        [this] { return ! search.ceramics.empty(); });
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
    const auto extent = extentOf (outlineOf (draft.document()));
    draft.apply (withPoint (draft.document(), pointsOf (draft.document()).size(),
                            { 500 * (extent.least + extent.largest), stiffness, mass }));
}

void DevicePanel::makePoints()
{
    Section section { "Feet and masses", {}, {} };
    const auto point = [this] (const nlohmann::json& device) -> std::optional<DrawnPoint>
    {
        const auto all = pointsOf (device);
        return draft.point && *draft.point < all.size() ? std::optional (all[*draft.point]) : std::nullopt;
    };

    for (const auto isMass : { false, true })
        addNumber (section, { isMass ? "Mass" : "Foot", isMass ? "g" : "N/mm",
                              isMass ? "Of the selected one" : "Stiffness of the selected one", 0.01, 1000, 20, 0,
                              [isMass, point] (const nlohmann::json& device) -> std::optional<double>
                              {
                                  const auto chosen = point (device);
                                  const auto value = chosen ? isMass ? chosen->mass : chosen->stiffness : 0;
                                  return value > 0 ? std::optional (value) : std::nullopt;
                              },
                              [this, isMass, point] (const nlohmann::json& device, double value)
                              {
                                  auto changed = *point (device);
                                  (isMass ? changed.mass : changed.stiffness) = value;
                                  return withPoint (device, *draft.point, changed);
                              } });

    constexpr double usualStiffness = 20, usualMass = 10;
    for (const auto isMass : { false, true })
        addButton (
            section, isMass ? "Add a mass" : "Add a foot",
            "In the middle, to be dragged; a right click adds it where it is wanted",
            [this, isMass] { addPoint (isMass ? 0 : usualStiffness, isMass ? usualMass : 0); },
            [this] { return isOfPlate(); });

    sections.push_back (std::move (section));
}
} // namespace antinode
