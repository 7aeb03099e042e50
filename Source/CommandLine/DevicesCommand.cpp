#include "Commands.h"
#include "FieldOptions.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusWords.h>
#include <antinode_documents/Inputs.h>
#include <antinode_structure/Materials.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
constexpr int materialColumn = 21;

struct DevicesOptions
{
    bool showsMaterials = false, showsFocuses = false;
    std::string shown;
};

std::string firstSentence (const std::string& text)
{
    const auto end = text.find (". ");
    return end == std::string::npos ? text : text.substr (0, end + 1);
}

void listDevices()
{
    for (const auto& name : factoryNames (LibraryKind::device))
    {
        const auto document = loadDocument (LibraryKind::device, name);
        std::printf ("%-16s %-7s %2zu ceramics  %s\n", name.c_str(), document.at ("kind").get<std::string>().c_str(),
                     document.value ("ceramics", nlohmann::json::array()).size(),
                     firstSentence (document.value ("description", "")).c_str());
    }
}

/** "sinc of 25 mm at 24 mm, 40 mm/s, after 25 ms". */
std::string targetsInWords (const FocusDescription& focus)
{
    std::string text;

    for (const auto& target : focus.targets)
    {
        const auto place =
            inWords (target.x * milli) + (target.y != 0 ? ", " + inWords (target.y * milli) : "") + " mm";
        text += (text.empty() ? "" : "; ") + std::string (wordFor (targetShapeWords, target.shape)) + " of "
                + inWords (target.width * milli) + " mm at " + place + ", "
                + inWords (target.phase * target.peakVelocity * milli) + " mm/s, after "
                + inWords (target.time.value_or (focus.focusTime) * milli) + " ms";
    }

    return text;
}

void listFocuses()
{
    for (const auto& name : factoryNames (LibraryKind::focus))
        std::printf ("%-16s %s\n", name.c_str(), targetsInWords (loadFocus (name, {})).c_str());
}

void printNotes (const MaterialNotes& notes)
{
    std::printf ("%*s %s; source: %s\n", materialColumn, "", std::string (notes.scatter).c_str(),
                 std::string (notes.source).c_str());
}

void printElastic (const std::string& name, const ElasticMaterial& material)
{
    std::printf ("%-*s E %g GPa", materialColumn, name.c_str(), material.youngsModulus1 / 1e9);

    if (material.youngsModulus2 != material.youngsModulus1)
        std::printf (" along x, %g along y, G12 %g GPa", material.youngsModulus2 / 1e9, material.shearModulus / 1e9);

    std::printf (", Poisson's ratio %g, density %g kg/m3\n", material.poissonRatio12, material.density);
}

void printPiezoelectric (const std::string& name, const PiezoelectricMaterial& material)
{
    std::printf ("%-*s E %g GPa, Poisson's ratio %g, density %g kg/m3, d31 %g m/V, ", materialColumn, name.c_str(),
                 material.youngsModulus / 1e9, material.poissonRatio, material.density, material.d31);

    if (material.fibres)
        std::printf ("across the fibres E %g GPa, d32 %g m/V, electrodes %g mm apart\n",
                     material.fibres->youngsModulus2 / 1e9, material.fibres->d32,
                     material.fibres->electrodeDistance * milli);
    else
        std::printf ("relative permittivity %g\n", material.permittivityRelative);
}

void printViscoelastic (const std::string& name, const ViscoelasticMaterial& material)
{
    std::printf ("%-*s density %g kg/m3; shear modulus and loss factor", materialColumn, name.c_str(),
                 material.density);

    for (const auto& row : material.table)
        std::printf ("%s %g MPa, %g at %g Hz", &row == &material.table.front() ? "" : ";", row.shearModulus / 1e6,
                     row.lossFactor, row.frequency);

    std::printf ("\n");
}

void listMaterials()
{
    std::printf ("Plates and layers\n\n");

    for (const auto& [notes, material] : elasticMaterials())
    {
        printElastic (std::string (notes.name), material);
        printNotes (notes);
    }

    std::printf ("\nCeramics\n\n");

    for (const auto& [notes, material] : piezoelectricMaterials())
    {
        printPiezoelectric (std::string (notes.name), material);
        printNotes (notes);
    }

    std::printf ("\nSoft layers\n\n");

    for (const auto& [notes, material] : viscoelasticMaterials())
    {
        printViscoelastic (std::string (notes.name), material);
        printNotes (notes);
    }
}

/** No two documents have one name. */
LibraryKind kindOf (const std::string& name)
{
    for (const auto kind : { LibraryKind::focus, LibraryKind::waveforms })
        if (const auto names = factoryNames (kind); std::find (names.begin(), names.end(), name) != names.end())
            return kind;

    return LibraryKind::device;
}

void run (const DevicesOptions& options)
{
    if (! options.shown.empty())
        std::printf ("%s\n", loadDocument (kindOf (options.shown), options.shown).dump (2).c_str());
    else if (options.showsMaterials)
        listMaterials();
    else if (options.showsFocuses)
        listFocuses();
    else
        listDevices();
}
} // namespace

void addDevicesCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("devices", "Lists the embedded devices, focuses and materials");
    auto options = std::make_shared<DevicesOptions>();
    addFields (*command,
               { Field ("--materials", &options->showsMaterials,
                        "Lists the built-in materials with values, scatter and sources"),
                 Field ("--focuses", &options->showsFocuses, "Lists the embedded focuses").without ("--materials"),
                 Field ("--show", &options->shown,
                        "Writes an embedded device, focus or waveforms as JSON, as a starting point for new ones")
                     .written ("NAME")
                     .without ("--materials")
                     .without ("--focuses") });
    command->callback ([options] { run (*options); });
}
} // namespace antinode
