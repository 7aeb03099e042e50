#include "Commands.h"
#include "ExcitationOptions.h"

#include <antinode_base/InputError.h>
#include <antinode_text/WaveFile.h>

#include <cmath>
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

/** All runs one after the other. */
Eigen::MatrixXd playedRuns (const ExcitationSheet& sheet)
{
    constexpr double maximumBytes = 512.0 * 1024 * 1024, bytesPerSample = 4;
    const auto& excitation = sheet.excitation;
    const auto ceramics = excitation.ceramics(), samples = ceramics * excitation.runLength;

    if (static_cast<double> (samples) * static_cast<double> (ceramics + 1) * bytesPerSample > maximumBytes)
        throw InputError ("excitation", "would make a file of more than 512 MiB; choose fewer periods, a coarser "
                                        "resolution or a lower rate, or use `antinode measure`, which needs no file");

    Eigen::MatrixXd played (ceramics + 1, samples);

    for (Eigen::Index i = 0; i < ceramics; ++i)
        played.middleCols (i * excitation.runLength, excitation.runLength) =
            playedRun (excitation, i, sheet.fullScaleVoltage);

    return played;
}

void excite (const ExciteOptions& options)
{
    const auto model = excitedDevice (options.excitation);
    const auto sheet = excitationFor (model, options.excitation);
    const auto& excitation = sheet.excitation;
    const auto& settings = excitation.settings;
    const auto played = playedRuns (sheet);

    OutputFolder folder (options.folder);
    folder.write ("excitation.wav", encodeWave (played, 1, settings.sampleRate));
    writeSheet (folder, sheet);
    folder.commit();

    std::printf ("%s: %td ceramics and a sync channel, %.1f s at %.0f Hz\n", model.name.c_str(), excitation.ceramics(),
                 static_cast<double> (played.cols()) / settings.sampleRate, settings.sampleRate);
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
