#include "Commands.h"
#include "FieldOptions.h"

#include <antinode_numerics/Median.h>
#include <antinode_tasks/Retune.h>
#include <antinode_text/OutputFolder.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
/** Of responses that are not the device's, and of points that fit it much worse than the others: elsewhere, turned
   over, or loose. */
void warnOfMisfit (const RetunedModel& retuned)
{
    constexpr double poor = 0.3, worseThanOthers = 3, quarter = -12; // dB
    const auto& errors = retuned.pointErrors;

    if (retuned.reconstructionError > quarter)
        std::printf ("  warning: more than a quarter of the measured responses is not explained; are device, points, "
                     "and order and "
                     "signs of the ceramics right?\n");

    const auto usual = median ({ errors.begin(), errors.end() });

    for (Eigen::Index p = 0; p < errors.size(); ++p)
        if (errors[p] > poor && errors[p] > worseThanOthers * usual)
            std::printf ("  warning: point %td: %.0f %% of its responses are not explained; is it where the file says, "
                         "and its sign right?\n",
                         p + 1, 100 * errors[p]);
}

void print (const ModalModel& before, const RetunedModel& retuned)
{
    constexpr double million = 1e6, percent = 100;
    std::printf ("%s: reconstruction error %.1f dB, delay %.3f us\n", retuned.model.name.c_str(),
                 retuned.reconstructionError, million * retuned.delay);
    std::printf ("%5s %14s %14s %12s %12s\n", "mode", "before (Hz)", "now (Hz)", "change (ppm)", "damping (%)");

    for (Eigen::Index k = 0; k < retuned.model.modes(); ++k)
        std::printf ("%5td %14.3f %14.3f %12.1f %12.2f%s\n", k + 1, before.frequencyHz (k),
                     before.frequencyHz (k) * (1 + retuned.frequencyChanges[k]), million * retuned.frequencyChanges[k],
                     percent * retuned.dampingChanges[k],
                     retuned.found[static_cast<std::size_t> (k)] ? "" : "  not found, shifted with its neighbours");

    for (Eigen::Index i = 0; i < retuned.participationScales.size(); ++i)
        std::printf ("ceramic %s has %.2f %% of its former participation\n",
                     before.ceramics[static_cast<std::size_t> (i)].name.c_str(),
                     percent * retuned.participationScales[i]);
}
} // namespace

void addRetuneCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (retuneText.name, retuneText.summary);
    auto request = std::make_shared<RetuneRequest>();
    auto file = std::make_shared<std::filesystem::path>();
    auto options = fields (*request);
    options.push_back (Field ("--out", file.get(), "Device file to write").written ("DEVICE.json").required());
    command->callback (
        [request, file, read = addFields (*command, options)]
        {
            read();
            const auto retuned = retune (*request, {});
            writeWholeFile (*file, retunedDeviceText (retuned));
            print (retuned.before, retuned.now);

            for (const auto& remark : retuned.remarks)
                std::printf ("  note: %s\n", remark.c_str());

            warnOfMisfit (retuned.now);
        });
}
} // namespace antinode
