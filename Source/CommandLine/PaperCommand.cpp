#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_charts/Picture.h>
#include <antinode_charts/Theme.h>
#include <antinode_library/Inputs.h>
#include <antinode_paper/PaperResults.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct PaperOptions
{
    std::string folder = "antinode-paper";
    bool isQuiet = false;
};

constexpr float pictureScale = 2;

void reproduce (const PaperOptions& options)
{
    Progress progress (options.isQuiet);
    const auto model = solveStructure (loadDevice ("staple", {}));
    const auto cells =
        evaluatePaperCells (model, [&] (const auto& what, double share) { progress.show (what, share); });
    const auto study = evaluateTwoModes (model);
    const auto figures = paperFigures (model, cells, study);
    const auto tables = makePaperTables (cells, study);
    OutputFolder folder (options.folder);

    for (const auto& figure : figures)
    {
        progress.show ("Drawing",
                       static_cast<double> (&figure - figures.data()) / static_cast<double> (figures.size()));
        folder.write (figure.name + ".png",
                      renderPng (figure.chart, figure.width, figure.height, pictureScale, Theme::light()));
    }

    folder.write ("report.html", renderReport (paperReport (model, tables, figures)));
    folder.write ("paper.json", paperJson (cells, study, figures).dump (2) + "\n");
    folder.commit();

    if (options.isQuiet)
        return;

    for (const auto& table : tables)
        std::printf ("%s\n", plainText (table).c_str());

    std::printf ("Figures and numbers: %s/report.html\n", options.folder.c_str());
}
} // namespace

void addPaperCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "paper",
        "Reproduces the paper's tables and figures on the demonstrator and compares them with the printed numbers");
    auto options = std::make_shared<PaperOptions>();
    addFields (*command, { Field ("--out", &options->folder, "Output folder"), quietField (options->isQuiet) });
    command->callback ([options] { reproduce (*options); });
}
} // namespace antinode
