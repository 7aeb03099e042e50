#include "Drawing.h"
#include "Lettering.h"
#include "Report.h"
#include "Theme.h"
#include "VectorFile.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
// Pixels, of which 5 are a millimetre.
constexpr int sheetWidth = 1050, sheetHeight = 1485; // A4
constexpr float sheetMargin = 75, lineSpacing = 1.15f, cellGap = 14;

TextStyle printed (float height, bool bold = false)
{
    return { height, bold, Theme::print().text };
}

TextStyle plainText()
{
    return printed (18);
}

TextStyle smallText()
{
    return printed (16);
}

TextStyle cellText (bool isHead)
{
    return printed (15, isHead);
}

/** Lines of a text that fit a width; a longer word has a line of its own. */
std::vector<std::string> wrapped (const std::string& text, float width, const TextStyle& style)
{
    std::vector<std::string> lines;
    std::istringstream words (text);

    for (std::string word; words >> word;)
        if (auto longer = lines.empty() ? word : lines.back() + " " + word;
            lines.empty() || textWidth (longer, style) > width)
            lines.push_back (word);
        else
            lines.back() = std::move (longer);

    return lines;
}

/** The width of the widest of some texts, and of their widest word. */
struct TextWidths
{
    float whole = 0, word = 0;

    void include (const std::string& text, const TextStyle& style)
    {
        whole = std::max (whole, textWidth (text, style));

        for (const auto& each : wrapped (text, 0, style))
            word = std::max (word, textWidth (each, style));
    }
};

/** As wide as its texts where there is room, else lines are broken in the longest; shortened where even words do not
   fit. */
std::vector<float> columnWidths (const ReportTable& table, float available)
{
    std::vector<TextWidths> texts (table.header.size());

    for (std::size_t column = 0; column < texts.size(); ++column)
    {
        texts[column].include (table.header[column], cellText (true));

        for (const auto& row : table.rows)
            if (column < row.size())
                texts[column].include (row[column], cellText (false));
    }

    available -= cellGap * static_cast<float> (texts.size());
    float words = 0, more = 0;

    for (const auto& text : texts)
    {
        words += text.word;
        more += text.whole - text.word;
    }

    const auto share = more > 0 ? std::clamp ((available - words) / more, 0.0f, 1.0f) : 0;
    const auto scale = std::min (1.0f, available / std::max (words, 1.0f));
    std::vector<float> widths (texts.size());
    std::transform (texts.begin(), texts.end(), widths.begin(),
                    [&] (const TextWidths& text)
                    { return cellGap + scale * text.word + share * (text.whole - text.word); });
    return widths;
}

/** A page of a report on sheets of paper, from above to below. */
class PrintedReport
{
public:
    std::string print (const ReportPage& page)
    {
        footer = page.footer;
        addFooter();
        addText (page.title, printed (30, true));
        addText (page.subtitle, plainText());

        for (const auto& score : page.scores)
            addText (score.name + ": " + score.value + ". " + score.sentence, plainText());

        if (! page.warnings.empty())
            addHeading ("Warnings", 0);

        for (const auto& warning : page.warnings)
            addText (warning, plainText());

        for (const auto& section : page.sections)
            addSection (section);

        return file.finish();
    }

private:
    static constexpr float width = sheetWidth - 2 * sheetMargin, bottom = sheetHeight - sheetMargin;

    void addSection (const ReportSection& section)
    {
        addHeading (section.heading, section.figures.empty() || ! section.paragraphs.empty()
                                         ? 0
                                         : sizeOf (section.figures.front()).getHeight());

        for (const auto& paragraph : section.paragraphs)
            addText (paragraph, plainText());

        for (const auto& figure : section.figures)
            addFigure (figure);

        for (const auto& table : section.tables)
            addTable (table);
    }

    void addFooter()
    {
        const auto style = smallText();
        const juce::Rectangle<float> line (sheetMargin, bottom + style.height, width, style.height);
        drawText (file.graphics(), footer, line.withTrimmedRight (cellGap + textWidth ("Page 000", style)),
                  juce::Justification::centredLeft, style);
        drawText (file.graphics(), "Page " + std::to_string (++number), line, juce::Justification::centredRight, style);
    }

    /** Begins the next sheet where this one has too little left, and gives whether it did. */
    bool require (float height)
    {
        const auto isFull = y + height > bottom && y > sheetMargin;

        if (isFull)
        {
            file.nextPage();
            y = sheetMargin;
            addFooter();
        }

        return isFull;
    }

    void addLines (const std::string& text, const TextStyle& style)
    {
        for (const auto& line : wrapped (text, width, style))
        {
            const auto height = style.height * lineSpacing;
            require (height);
            drawText (file.graphics(), line, { sheetMargin, y, width, height }, juce::Justification::centredLeft,
                      style);
            y += height;
        }
    }

    void addText (const std::string& text, const TextStyle& style)
    {
        addLines (text, style);
        y += text.empty() ? 0 : style.height / 2;
    }

    /** With the first lines, or the height of what follows, on the same sheet. */
    void addHeading (const std::string& text, float following)
    {
        const auto style = printed (22, true);
        y += y > sheetMargin ? style.height / 2 : 0;
        require (2 * style.height + std::max (following, 4 * plainText().height));
        addText (text, style);
    }

    static juce::Rectangle<float> sizeOf (const ReportFigure& figure)
    {
        const auto size = juce::Rectangle<int> (figure.width, figure.height).toFloat();
        const auto room = bottom - sheetMargin - 4 * plainText().height; // and its caption
        return size * std::min ({ 1.0f, width / size.getWidth(), room / size.getHeight() });
    }

    void addFigure (const ReportFigure& figure)
    {
        checkWatch();
        const auto size = sizeOf (figure);
        const auto lines = static_cast<float> (wrapped (figure.caption, width, smallText()).size());
        require (size.getHeight() + lines * smallText().height * lineSpacing);
        {
            auto& g = file.graphics();
            const juce::Graphics::ScopedSaveState state (g);
            g.addTransform (juce::AffineTransform::scale (size.getWidth() / static_cast<float> (figure.width))
                                .translated (sheetMargin, y));
            draw (g, juce::Rectangle<int> (figure.width, figure.height).toFloat(), figure.chart, Theme::print());
        }
        y += size.getHeight();
        addText (figure.caption, smallText());
    }

    void addTable (const ReportTable& table)
    {
        const auto widths = columnWidths (table, width);
        y += cellGap / 2;
        addRow (table, table.header, widths, true);

        for (const auto& row : table.rows)
        {
            checkWatch();
            addRow (table, row, widths, false);
        }

        y += cellGap / 2;
        addText (table.caption, smallText());
    }

    void addRow (const ReportTable& table, const std::vector<std::string>& cells, const std::vector<float>& widths,
                 bool isHead)
    {
        const auto style = cellText (isHead);
        std::vector<std::vector<std::string>> lines;
        std::size_t most = 0;

        for (std::size_t column = 0; column < std::min (cells.size(), widths.size()); ++column)
        {
            lines.push_back (wrapped (cells[column], widths[column] - cellGap, style));
            most = std::max (most, lines.back().size());
        }

        const auto height = style.height * lineSpacing;
        const auto all = static_cast<float> (most) * height + cellGap / 2;

        if (require (isHead ? 2 * all : all) && ! isHead)
            addRow (table, table.header, widths, true);

        auto& g = file.graphics();
        auto x = sheetMargin;

        for (std::size_t column = 0; column < lines.size(); ++column)
        {
            juce::Rectangle<float> area (x, y + cellGap / 4, widths[column] - cellGap, height);
            const auto place =
                isNumberColumn (table, column) ? juce::Justification::centredRight : juce::Justification::centredLeft;

            for (const auto& line : lines[column])
            {
                drawText (g, line, area, place, style);
                area.translate (0, height);
            }

            x += widths[column];
        }

        y += all;
        g.setColour (Theme::print().grid);
        g.fillRect (juce::Rectangle<float> (sheetMargin, y - 1, x - sheetMargin - cellGap, 1));
    }

    VectorFile file { VectorFormat::pdf, sheetWidth, sheetHeight };
    std::string footer;
    int number = 0;        ///< Of the sheet, from 1.
    float y = sheetMargin; ///< Where the next thing begins.
};
} // namespace

std::string renderReportPdf (const ReportPage& page)
{
    return PrintedReport().print (page);
}
} // namespace antinode
