#include "Commands.h"
#include "ExcitationOptions.h"
#include "ExcitedFiles.h"

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct ExciteOptions
{
    ExcitationOptions excitation;
    std::string folder;
};

void excite (const ExciteOptions& options)
{
    const auto model = excitedDevice (options.excitation);
    const auto sheet = excitationFor (model, options.excitation);
    const auto& excitation = sheet.excitation;
    const auto& settings = excitation.settings;
    writeExcitation (options.folder, sheet);

    std::printf ("%s: %td ceramics and a sync channel, %.1f s at %.0f Hz\n", model.name.c_str(), excitation.ceramics(),
                 static_cast<double> (excitation.ceramics() * excitation.runLength) / settings.sampleRate,
                 settings.sampleRate);
    std::printf ("  %s, %zu lines from %.6g to %.6g Hz, %.4g Hz apart\n", options.excitation.signal.c_str(),
                 excitation.lines.size(), excitation.lineFrequency (excitation.lines.front()),
                 excitation.lineFrequency (excitation.lines.back()),
                 settings.sampleRate / static_cast<double> (excitation.lineBlock));
    std::printf ("  crest factor %.2f, peak %.4g to %.4g V\n", excitation.crestFactor, settings.levels.minCoeff(),
                 settings.levels.maxCoeff());
    std::printf ("Play %s/excitation.wav, record, then run: antinode frf %s/excitation.json RECORDINGS\n",
                 options.folder.c_str(), options.folder.c_str());
}
} // namespace

void addExciteCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("excite", "Writes the excitation of the ceramics for a measurement of the surface");
    auto options = std::make_shared<ExciteOptions>();
    addExcitationOptions (*command, options->excitation);
    command->add_option ("--out", options->folder, "Output folder for excitation.wav and its sheet")
        ->required()
        ->type_name ("DIR");
    command->callback ([options] { excite (*options); });
}
} // namespace antinode
