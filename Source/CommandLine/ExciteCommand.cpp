#include "Commands.h"
#include "FieldOptions.h"

#include <antinode_tasks/Excite.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
void print (const ExcitationSheet& sheet, const std::string& signal, const std::string& folder)
{
    const auto& excitation = sheet.excitation;
    const auto& settings = excitation.settings;
    std::printf (
        "%s: %td ceramics and a sync channel, %.1f s at %.0f Hz\n", sheet.device.c_str(), excitation.ceramics(),
        static_cast<double> (excitation.ceramics() * excitation.runLength) / settings.sampleRate, settings.sampleRate);
    std::printf ("  %s, %zu lines from %.6g to %.6g Hz, %.4g Hz apart\n", signal.c_str(), excitation.lines.size(),
                 excitation.lineFrequency (excitation.lines.front()),
                 excitation.lineFrequency (excitation.lines.back()),
                 settings.sampleRate / static_cast<double> (excitation.lineBlock));
    std::printf ("  crest factor %.2f, peak %.4g to %.4g V\n", excitation.crestFactor, settings.levels.minCoeff(),
                 settings.levels.maxCoeff());
    std::printf ("Play %s/excitation.wav, record, then run: antinode frf %s/excitation.json RECORDINGS\n",
                 folder.c_str(), folder.c_str());
}
} // namespace

void addExciteCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (exciteText.name, exciteText.summary);
    auto request = std::make_shared<ExcitationRequest>();
    auto folder = std::make_shared<std::filesystem::path>();
    auto options = fields (*request);
    options.push_back (
        Field ("--out", folder.get(), "Output folder for excitation.wav and its sheet").written ("DIR").required());
    command->callback (
        [request, folder, read = addFields (*command, options)]
        {
            read();
            const auto sheet = excite (*request, {});
            writeExcitation (*folder, sheet);
            print (sheet, request->signal, folder->string());
        });
}
} // namespace antinode
