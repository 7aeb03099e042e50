#include "FigureFiles.h"

#include <antinode_numerics/ParallelFor.h>

namespace antinode
{
namespace
{
/** Lower-case letters and digits, all else as single hyphens. */
std::string fileWord (const std::string& text)
{
    std::string word;

    for (const auto character : text)
    {
        const auto isLetter = (character >= 'a' && character <= 'z') || (character >= '0' && character <= '9');
        const auto isCapital = character >= 'A' && character <= 'Z';

        if (isLetter || isCapital)
            word += isCapital ? static_cast<char> (character - 'A' + 'a') : character;
        else if (! word.empty() && word.back() != '-')
            word += '-';
    }

    while (! word.empty() && word.back() == '-')
        word.pop_back();

    return word;
}
} // namespace

std::vector<NamedFigure> namedFigures (const ReportPage& page)
{
    std::vector<NamedFigure> figures;

    for (const auto& section : page.sections)
        for (std::size_t i = 0; i < section.figures.size(); ++i)
            figures.push_back (
                { "figure-" + fileWord (section.heading) + "-" + std::to_string (i + 1), &section.figures[i] });

    return figures;
}

void writeFigures (OutputFolder& folder, const ReportPage& page, VectorFormat format)
{
    const auto figures = namedFigures (page);
    std::vector<std::string> files (figures.size());
    parallelFor (figures.size(),
                 [&] (std::size_t i)
                 {
                     const auto& figure = *figures[i].figure;
                     files[i] = renderVector (figure.chart, figure.width, figure.height, format);
                 });

    for (std::size_t i = 0; i < figures.size(); ++i)
        folder.write (figures[i].name + (format == VectorFormat::svg ? ".svg" : ".pdf"), files[i]);
}
} // namespace antinode
