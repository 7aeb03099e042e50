#include "ModeTable.h"

#include <antinode_text/CsvText.h>

namespace antinode
{
std::string encodeModeTable (const ModalModel& model)
{
    constexpr int significantDigits = 17;
    std::string text = "mode,frequency_Hz,damping_ratio,error_estimate_relative";
    const auto appendNumber = [&] (double value)
    {
        text += ',';
        appendCsvNumber (text, value, significantDigits);
    };

    for (const auto& ceramic : model.ceramics)
        text += ',' + csvField ("participation_" + ceramic.name + "_per_V");

    if (model.hasComplexModes())
        for (const auto& ceramic : model.ceramics)
            text += ',' + csvField ("participation_imaginary_" + ceramic.name + "_per_V");

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        text += '\n' + std::to_string (k + 1);
        appendNumber (model.frequencyHz (k));
        appendNumber (model.dampingRatios[k]);

        if (model.frequencyErrors.size() > 0)
            appendNumber (model.frequencyErrors[k]);
        else
            text += ',';

        for (Eigen::Index i = 0; i < model.actuators(); ++i)
            appendNumber (model.participation (k, i));

        if (model.hasComplexModes())
            for (Eigen::Index i = 0; i < model.actuators(); ++i)
                appendNumber (model.participation (model.modes() + k, i));
    }

    return text + '\n';
}
} // namespace antinode
