// The charts: poles, mode indicator, one response with its synthesis and its error.

/** Poles of all orders, candidates as lines. A click picks or rejects the candidate nearest to what was hit. */
function stabilisationPlot (state, onClick)
{
    const { data, range, picks } = state;
    const poles = { frequency: doublesOf (data.poles.frequency), order: bytesOf (data.poles.order), isStable: bytesOf (data.poles.stable) };
    const lowest = Math.min (...new Set (poles.order), 255), highest = Math.max (...new Set (poles.order), 1);
    state.shownPoles = () => poles.frequency.filter ((frequency) => frequency >= range.shown[0] && frequency <= range.shown[1]).length;

    const nameOf = (candidate) => ! candidate.isPicked ? "" : candidate.mode === null ? "new" : String (candidate.mode + 1);
    const content = (plot) =>
    {
        let lastName = -Infinity;

        for (const candidate of picks.candidates.filter ((one) => plot.shows (one.frequency)))
        {
            const hasRoom = plot.x (candidate.frequency) > lastName + 24;
            plot.marker (candidate.frequency, colour (candidate.isPicked ? "accent" : "alone"),
                         { name: hasRoom ? nameOf (candidate) : "", width: candidate === state.candidate ? 3 : 1,
                           dash: candidate.isPicked ? [] : [3, 4] });
            lastName = hasRoom && candidate.isPicked ? plot.x (candidate.frequency) : lastName;
        }

        for (let n = 0; n < poles.frequency.length; ++n)
            if (plot.shows (poles.frequency[n]))
                plot.dot (poles.frequency[n], poles.order[n], colour (poles.isStable[n] ? "accent" : "measured"), poles.isStable[n] ? 3 : 2);
    };

    return new Plot (document.getElementById ("stabilisation"), range,
                     { label: "model order", yRange: () => [Math.min (lowest, highest) - 1, highest + 1], content, onClick, onHover: state.hover });
}

function indicatorPlot (state)
{
    const { data, range, frequencies, picks } = state;
    const curves = data.indicator.map (floatsOf);
    const logarithms = curves.map ((values) => values.map ((value) => value > 0 ? Math.log10 (value) : NaN));
    const content = (plot) =>
    {
        for (const candidate of picks.picked.filter ((one) => plot.shows (one.frequency)))
            plot.marker (candidate.frequency, colour ("line"), { width: 2 });

        logarithms.forEach ((values, n) => plot.curve (frequencies, (f) => values[f],
                                                        colour (["accent", "warn", "second"][n] ?? "measured"), { width: n < 3 ? 1.4 : 0.8 }));
    };
    return new Plot (document.getElementById ("indicator"), range,
                     { label: data.unit, yRange: () => decadesShown (state, logarithms, 6), content, tickText: powerText, onHover: state.hover });
}

const powerText = (exponent) => (10 ** exponent).toExponential (0).replace ("+", "");

/** The ends of logarithms over the shown frequencies, at most so many decades. */
function decadesShown ({ range, frequencies }, curves, most)
{
    let lowest = Infinity, highest = -Infinity;

    for (const values of curves)
        for (let n = 0; n < values.length; ++n)
            if (frequencies[n] >= range.shown[0] && frequencies[n] <= range.shown[1] && Number.isFinite (values[n]))
                [lowest, highest] = [Math.min (lowest, values[n]), Math.max (highest, values[n])];

    return highest > -Infinity ? [Math.max (lowest, highest - most) - 0.1, highest + 0.2] : [-1, 1];
}

/** Magnitude, phase and error of the response of state.point and state.reference. */
function responsePlots (state)
{
    const { data, range, frequencies } = state;
    const shown = {};
    const legendOf = (plot, entries) => plot.legend (entries.map (([name, key]) => [name, colour (key)]));
    const magnitude = new Plot (document.getElementById ("magnitude"), range, {
        label: data.unit, tickText: powerText, onHover: state.hover,
        yRange: () => decadesShown (state, [shown.measured, shown.synthesised], 7),
        content: (plot) =>
        {
            plot.curve (frequencies, (n) => shown.error[n], colour ("warn"), { width: 0.8 });
            plot.curve (frequencies, (n) => shown.measured[n], colour ("measured"), { width: 2.4 });
            plot.curve (frequencies, (n) => shown.synthesised[n], colour ("accent"), { width: 1.4 });
            legendOf (plot, [["measured", "measured"], ["synthesised from the picked modes", "accent"], ["difference", "warn"]]);
        } });
    const phase = new Plot (document.getElementById ("phase"), range, {
        label: "degrees", yRange: () => [-190, 190], yTicks: () => [-180, -90, 0, 90, 180], onHover: state.hover,
        content: (plot) =>
        {
            frequencies.forEach ((frequency, n) => plot.shows (frequency) && Number.isFinite (shown.phase[n])
                                                       && plot.dot (frequency, shown.phase[n], colour ("measured"), 1.4));
            plot.curve (frequencies, (n) => shown.modelPhase[n], colour ("accent"), { width: 1.4, leap: 180 });
        } });
    const all = floatsOf (data.measuredSize).map ((size, n) => decibels (state.errorSize[n] / size));
    const error = new Plot (document.getElementById ("error"), range, {
        label: "error (dB)", onHover: state.hover, yRange: () => [-80, 20],
        content: (plot) =>
        {
            plot.curve (frequencies, (n) => shown.relative[n], colour ("warn"), { width: 0.9 });
            plot.curve (frequencies, (n) => all[n], colour ("accent"), { width: 1.6 });
            legendOf (plot, [["this response", "warn"], ["all responses, as fitted", "accent"]]);
        } });
    return { update: () => Object.assign (shown, curvesOf (state)), draw: () => [magnitude, phase, error].forEach ((plot) => plot.draw()) };
}

/** The curves of the chosen response. Phases are without the common delay, those of the measurement only where it stands out of its noise. */
function curvesOf (state)
{
    const { measured, synthesised, frequencies, data } = state;
    const size = (values) => values.real.map ((real, n) => Math.hypot (real, values.imaginary[n]));
    const difference = { real: measured.real.map ((real, n) => real - synthesised.real[n]),
                         imaginary: measured.imaginary.map ((imaginary, n) => imaginary - synthesised.imaginary[n]) };
    const measuredSize = size (measured), noise = localNoise (measured), error = size (difference);
    const logarithm = (values) => values.map ((value) => value > 0 ? Math.log10 (value) : NaN);
    const phase = ({ real, imaginary }) => real.map ((value, n) => {
        const turns = Math.atan2 (imaginary[n], value) / (2 * Math.PI) + frequencies[n] * data.delay;
        return 360 * (turns - Math.round (turns));
    });
    return { measured: logarithm (measuredSize), synthesised: logarithm (size (synthesised)), error: logarithm (error),
             phase: phase (measured).map ((value, n) => measuredSize[n] > 2 * noise[n] ? value : NaN), modelPhase: phase (synthesised),
             relative: error.map ((value, n) => decibels (value / measuredSize[n])),
             total: decibels (Math.sqrt (sumOfSquares (error) / sumOfSquares (measuredSize))) };
}

const sumOfSquares = (values) => values.reduce ((sum, value) => sum + (Number.isFinite (value) ? value * value : 0), 0);

/** The noise around each line: second differences of white noise have six times its energy. */
function localNoise ({ real, imaginary })
{
    const reach = 12, square = new Float64Array (real.length);

    for (let n = 1; n + 1 < real.length; ++n)
        square[n] = ((real[n - 1] - 2 * real[n] + real[n + 1]) ** 2 + (imaginary[n - 1] - 2 * imaginary[n] + imaginary[n + 1]) ** 2) / 6;

    return square.map ((_, n) => {
        const near = square.slice (Math.max (n - reach, 0), n + reach + 1).sort(); // A median: resonances between few lines are no noise.
        return Math.sqrt (near[near.length >> 1] / Math.LN2);
    });
}
