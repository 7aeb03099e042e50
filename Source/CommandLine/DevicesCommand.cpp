#include "Commands.h"

#include <antinode_library/Inputs.h>
#include <antinode_structure/Materials.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
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

void listFocuses()
{
    for (const auto& name : factoryNames (LibraryKind::focus))
        std::printf ("%-22s %s\n", name.c_str(), loadDocument (LibraryKind::focus, name).value ("name", "").c_str());
}

void listMaterials()
{
    for (const auto& name : elasticMaterialNames())
    {
        const auto material = findElasticMaterial (name).value();
        std::printf ("%-10s E %g GPa, Poisson's ratio %g, density %g kg/m3\n", name.c_str(),
                     material.youngsModulus1 / 1e9, material.poissonRatio12, material.density);
    }

    for (const auto& name : piezoelectricMaterialNames())
    {
        const auto material = findPiezoelectricMaterial (name).value();
        std::printf ("%-10s E %g GPa, Poisson's ratio %g, density %g kg/m3, d31 %g m/V, relative permittivity %g\n",
                     name.c_str(), material.youngsModulus / 1e9, material.poissonRatio, material.density, material.d31,
                     material.permittivityRelative);
    }
}

void run (const DevicesOptions& options)
{
    if (! options.shown.empty())
        std::printf ("%s\n", loadDocument (LibraryKind::device, options.shown).dump (2).c_str());
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
    auto* materials =
        command->add_flag ("--materials", options->showsMaterials, "Lists the built-in materials with their values");
    auto* focuses = command->add_flag ("--focuses", options->showsFocuses, "Lists the embedded focuses");
    auto* shown = command->add_option ("--show", options->shown,
                                       "Writes an embedded device as JSON, as a starting point for a new device");
    materials->excludes (focuses)->excludes (shown);
    focuses->excludes (shown);
    command->callback ([options] { run (*options); });
}
} // namespace antinode
