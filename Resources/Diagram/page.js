// The page: what is chosen, and what follows from it. Part of it is in the address after #, so that it can be kept and sent:
// zoom=300:900&pick=1234.5&reject=696,1898&point=3&reference=1&mode=2&at=700 (frequencies in Hz, numbers from 1).

const element = (id) => document.getElementById (id);

/** Errors are counted where a test sees them, and said where a reader does. */
window.addEventListener ("error", (event) => {
    document.body.dataset.errors = String (Number (document.body.dataset.errors) + 1);
    element ("message").textContent = "Script error: " + event.message;
});

const data = JSON.parse (element ("data").textContent);
const frequencies = doublesOf (data.frequencies);
const state = {
    data, frequencies, range: new Range (...data.band), picks: new Picks (data.candidates), errorSize: floatsOf (data.errorSize),
    synthesis: new Synthesis (data, frequencies), point: 0, reference: 0, candidate: null, at: null
};
state.hover = (frequency) => { state.at = frequency; showReadout(); };

const isKept = (mode) => state.picks.candidates.some ((candidate) => candidate.mode === mode && candidate.isPicked);

/** Measured responses are kept as what the modes as fitted leave of them. */
function readResponse()
{
    const { real, imaginary } = state.synthesis.response (state.point, state.reference, () => true);
    const { residual, largest } = data.responses[state.reference][state.point];
    const rest = complexOf (residual, largest);
    state.measured = { real: real.map ((value, n) => value + rest.real[n]), imaginary: imaginary.map ((value, n) => value + rest.imaginary[n]) };
}

function showResponse()
{
    state.synthesised = state.synthesis.response (state.point, state.reference, isKept);
    state.curves = responses.update();
    element ("response-error").textContent = "Error of this response in the band: " + state.curves.total.toFixed (1) + " dB";
    responses.draw();
    showReadout();
}

function showReadout()
{
    if (state.at === null || ! state.synthesised)
        return;

    const upper = Math.min (firstShown (frequencies, state.at) + 1, frequencies.length - 1);
    const n = upper > 0 && state.at - frequencies[upper - 1] < frequencies[upper] - state.at ? upper - 1 : upper;
    const size = ({ real, imaginary }) => Math.hypot (real[n], imaginary[n]);
    const difference = Math.hypot (state.measured.real[n] - state.synthesised.real[n], state.measured.imaginary[n] - state.synthesised.imaginary[n]);
    element ("readout").textContent = `${written (frequencies[n], 7)} Hz: measured ${written (size (state.measured), 4)}, synthesised `
        + `${written (size (state.synthesised), 4)} ${data.unit}, error ${decibels (difference / size (state.measured)).toFixed (1)} dB`;
}

function showPicks()
{
    const { picks } = state;
    const added = picks.changed.filter ((candidate) => candidate.isPicked).length, rejected = picks.changed.length - added;
    element ("line").textContent = picks.line || "Nothing is picked: antinode identify needs one mode or more.";
    element ("count").textContent = `${picks.picked.length} of ${picks.candidates.length} candidates are picked.`;
    element ("changes").textContent = picks.changed.length === 0 ? "As fitted." :
        `${rejected} rejected, ${added} new. Run antinode identify again with this option to fit them.`;

    for (const row of element ("candidates").rows)
        row.cells[0].firstChild.checked = picks.candidates[row.rowIndex - 1].isPicked;

    stabilisation.draw();
    indicator.draw();
    showResponse();
}

/** What a candidate is: a mode with its shape, or a pole without one. */
function chooseCandidate (candidate)
{
    state.candidate = candidate;
    const mode = candidate?.mode ?? null;
    element ("mode-title").textContent = ! candidate ? "Mode shape" : mode === null ? `Candidate at ${written (candidate.frequency, 6)} Hz`
                                                     : `Mode ${mode + 1}: ${written (data.modes[mode].frequency, 6)} Hz`;
    element ("mode-facts").textContent = ! candidate ? "" : mode === null ? "It was not fitted: it has no shape yet."
        : [`Damping ${written (100 * data.modes[mode].damping, 3)} %, MPC ${written (data.modes[mode].collinearity, 3)}.`,
           ...data.modes[mode].warnings].join (" Warning: ");
    shape.show (mode === null ? shape.x.map (() => 0) : state.synthesis.shape[mode], mode === null ? null : state.synthesis.shapeImaginary[mode]);

    for (const row of element ("candidates").rows)
        row.classList.toggle ("chosen", state.picks.candidates[row.rowIndex - 1] === candidate);

    stabilisation.draw();
}

function choosePoint (point, reference)
{
    [state.point, state.reference] = [point, reference];
    element ("point").selectedIndex = shape.point = point;
    element ("reference").selectedIndex = reference;
    readResponse();
    showResponse();
    shape.draw();
}

const toggle = (candidate) => state.picks.set ([candidate], (one) => ! one.isPicked);

/** The candidate within some pixels of a click. */
function clickDiagram (x)
{
    const candidate = state.picks.nearest (stabilisation.frequencyAt (x));
    const isNear = candidate && Math.abs (stabilisation.x (candidate.frequency) - x) < 8;
    element ("message").textContent = isNear ? "" : "No candidate is there: a candidate recurs at 15 % of the orders or more.";

    if (isNear)
    {
        toggle (candidate);
        chooseCandidate (candidate);
    }
}

function fillTable()
{
    for (const candidate of state.picks.candidates)
    {
        const mode = candidate.mode === null ? null : data.modes[candidate.mode];
        const row = element ("candidates").insertRow();
        const box = row.insertCell().appendChild (document.createElement ("input"));
        box.type = "checkbox";
        box.setAttribute ("aria-label", `Pick ${written (candidate.frequency, 6)} Hz`);
        box.addEventListener ("change", () => toggle (candidate));
        const cells = [mode ? candidate.mode + 1 : "", state.picks.text (candidate), written (100 * candidate.damping, 3),
                       Math.round (100 * candidate.presence), mode ? written (mode.collinearity, 3) : ""];
        cells.forEach ((text) => { row.insertCell().textContent = text; });
        row.classList.toggle ("warned", Boolean (mode?.warnings.length));
        row.title = mode?.warnings.join ("; ") ?? "";
        row.addEventListener ("click", (event) => event.target !== box && chooseCandidate (candidate));
    }
}

function fillChoices()
{
    const fill = (id, names) => element (id).append (...names.map ((name) => new Option (name)));
    fill ("point", data.points.names);
    fill ("reference", data.references);
    element ("shape").hidden = element ("motion").hidden = data.points.names.length < 2;
    element ("title").textContent = document.title = data.title;
    element ("subtitle").textContent = data.subtitle;

    if (data.report)
        Object.assign (element ("report"), { href: encodeURIComponent (data.report), textContent: "Report" });

    element ("lines-note").textContent = data.usedLines === frequencies.length ? `All ${frequencies.length} lines of the band are shown.`
        : `${frequencies.length} of the ${data.usedLines} lines of the band are shown, more of them where modes are narrow.`;
}

function showView()
{
    const digits = Math.max (0, Math.min (6, 3 - Math.floor (Math.log10 (state.range.shown[1] - state.range.shown[0]))));
    const ends = state.range.shown.map ((frequency) => frequency.toFixed (digits));
    element ("view").textContent = `${ends.join (" to ")} Hz, ${state.shownPoles()} poles`;
}

/** What the address says after #. */
function readAddress()
{
    const words = new URLSearchParams (location.hash.slice (1));
    const numbers = (name) => (words.get (name) ?? "").split (/[,:]/).filter (Boolean).map (Number);
    const within = (name, count) => Math.min (Math.max ((numbers (name)[0] || 1) - 1, 0), count - 1);
    const fitted = state.picks.candidates.filter ((one) => one.mode !== null);
    Plot.isSilent = true;
    const added = new Set (numbers ("pick").map ((frequency) => state.picks.nearest (frequency)));
    const rejected = new Set (numbers ("reject").map ((frequency) => state.picks.nearest (frequency, fitted)));
    state.picks.set (state.picks.candidates, (one) => ! rejected.has (one) && (added.has (one) || one.mode !== null));

    choosePoint (within ("point", data.points.names.length), within ("reference", data.references.length));
    chooseCandidate (state.picks.candidates.find ((one) => one.mode === within ("mode", data.modes.length)) ?? state.picks.candidates[0]);
    state.at = numbers ("at")[0] ?? null;
    showReadout();
    Plot.isSilent = false;
    state.range.show (...(numbers ("zoom").length === 2 ? numbers ("zoom") : state.range.shown));
}

function writeAddress()
{
    const said = (isPicked) => state.picks.changed.filter ((one) => one.isPicked === isPicked).map ((one) => state.picks.text (one)).join (",");
    const words = { zoom: state.range.shown.map ((frequency) => written (frequency, 7)).join (":"),
                    pick: said (true), reject: said (false), point: state.point + 1, reference: state.reference + 1, mode: (state.candidate?.mode ?? 0) + 1 };
    history.replaceState (null, "", "#" + Object.entries (words).filter (([, value]) => value !== "").map ((pair) => pair.join ("=")).join ("&"));
}

const shape = new ShapeView (element ("shape"), data.points, (point) => choosePoint (point, state.reference));
const stabilisation = stabilisationPlot (state, clickDiagram);
const indicator = indicatorPlot (state);
const responses = responsePlots (state);

function connect()
{
    const on = (id, event, action) => element (id).addEventListener (event, action);
    state.range.listeners.push (showView);
    state.picks.listeners.push (showPicks);
    on ("copy", "click", () => navigator.clipboard.writeText (state.picks.line).then (
        () => { element ("message").textContent = "Copied."; }, () => { element ("message").textContent = "Select the line and copy it."; }));
    on ("as-fitted", "click", () => state.picks.set (state.picks.candidates, (one) => one.mode !== null));
    on ("none", "click", () => state.picks.set (state.picks.candidates, () => false));
    on ("zoom-in", "click", () => state.range.zoom (0.5));
    on ("zoom-out", "click", () => state.range.zoom (2));
    on ("whole", "click", () => state.range.show (...state.range.whole));
    on ("point", "change", () => choosePoint (element ("point").selectedIndex, state.reference));
    on ("reference", "change", () => choosePoint (state.point, element ("reference").selectedIndex));
    on ("amplitude", "input", () => { shape.amplitude = Number (element ("amplitude").value); shape.draw(); });
    on ("play", "click", () => { shape.isMoving = ! shape.isMoving; showMotion(); });
    const drawAll = () => { palette.clear(); state.range.show (...state.range.shown); shape.draw(); };
    window.addEventListener ("resize", drawAll);
    window.matchMedia ("(prefers-color-scheme: dark)").addEventListener ("change", drawAll);
    window.addEventListener ("hashchange", readAddress);
    // Browsers allow few changes of the address in a second.
    document.addEventListener ("pointerup", () => setTimeout (writeAddress));
    document.addEventListener ("keyup", writeAddress);
}

const showMotion = () => { element ("play").textContent = shape.isMoving ? "Stop" : "Move"; };

function open()
{
    fillChoices();
    fillTable();
    readResponse();
    state.synthesised = state.measured;
    responses.update();
    connect();
    readAddress();
    showMotion();
    document.body.dataset.openedIn = String (Math.round (performance.now()));
    document.body.dataset.ready = "1";
}

open();
