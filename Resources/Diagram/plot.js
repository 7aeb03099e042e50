// Charts over frequency on canvases. All share one range of frequencies.

/** The frequencies that are shown, and the whole band. */
class Range
{
    constructor (minimum, maximum)
    {
        this.whole = [minimum, maximum];
        this.shown = [minimum, maximum];
        this.listeners = [];
    }

    show (minimum, maximum)
    {
        const narrowest = 1e-6 * (this.whole[1] - this.whole[0]);
        const width = Math.min (Math.max (maximum - minimum, narrowest), this.whole[1] - this.whole[0]);
        const from = Math.min (Math.max (minimum, this.whole[0]), this.whole[1] - width);
        this.shown = [from, from + width];

        for (const listener of this.listeners)
            listener();
    }

    /** Around a frequency, which stays where it is. */
    zoom (factor, frequency = (this.shown[0] + this.shown[1]) / 2)
    {
        this.show (frequency + (this.shown[0] - frequency) * factor, frequency + (this.shown[1] - frequency) * factor);
    }

    move (share)
    {
        const step = share * (this.shown[1] - this.shown[0]);
        this.show (this.shown[0] + step, this.shown[1] + step);
    }
}

const palette = new Map();

/** A colour of the style sheet, light or dark. They are asked for once: forget them by palette.clear(). */
function colour (name)
{
    if (! palette.has (name))
        palette.set (name, getComputedStyle (document.documentElement).getPropertyValue ("--" + name).trim());

    return palette.get (name);
}

/** The context of a canvas, cleared, whose units are pixels of the page. */
function cleared (canvas)
{
    const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = Math.round (width * scale);
    canvas.height = Math.round (height * scale);
    const context = canvas.getContext ("2d");
    context.scale (scale, scale);
    context.font = "12px system-ui, 'DejaVu Sans', sans-serif";
    return { context, width, height };
}

class Plot
{
    static isSilent = false; // While much changes at once.
    static margin = { left: 62, right: 28, top: 18, bottom: 22 };

    /** content (plot) draws; yRange() gives the ends of the y axis, yTicks (count) its labels; onClick (x, y) in pixels and
        onHover (frequency) may be missing. */
    constructor (canvas, range, { label, yRange, yTicks = (count) => ticksBetween (...this.ends, count), content, onClick, onHover,
                                  tickText = (value) => written (value, 4) })
    {
        Object.assign (this, { canvas, range, label, yRange, yTicks, content, onClick, onHover, tickText });
        range.listeners.push (() => this.draw());
        new Pointer (this);
    }

    x (frequency) { return this.left + (frequency - this.range.shown[0]) / (this.range.shown[1] - this.range.shown[0]) * this.plotWidth; }
    y (value) { return this.top + (this.ends[1] - value) / (this.ends[1] - this.ends[0]) * this.plotHeight; }
    frequencyAt (x) { return this.range.shown[0] + (x - this.left) / this.plotWidth * (this.range.shown[1] - this.range.shown[0]); }
    valueAt (y) { return this.ends[1] - (y - this.top) / this.plotHeight * (this.ends[1] - this.ends[0]); }
    shows (frequency) { return frequency >= this.range.shown[0] && frequency <= this.range.shown[1]; }

    draw()
    {
        if (Plot.isSilent)
            return;

        const { left, right, top, bottom } = Plot.margin;
        const { context, width, height } = cleared (this.canvas);
        Object.assign (this, { context, left, top, plotWidth: width - left - right, plotHeight: height - top - bottom, ends: this.yRange() });
        this.drawAxes();
        context.save();
        context.beginPath();
        context.rect (left, 0, this.plotWidth, top + this.plotHeight);
        context.clip();
        this.content (this);
        context.restore();
    }

    drawAxes()
    {
        const { context, left, top, plotWidth, plotHeight } = this;
        const line = (x1, y1, x2, y2) => { context.moveTo (x1, y1); context.lineTo (x2, y2); };
        context.strokeStyle = colour ("line");
        context.fillStyle = colour ("muted");
        context.lineWidth = 1;
        context.beginPath();
        context.textAlign = "center";

        for (const tick of ticksBetween (...this.range.shown, plotWidth / 90))
        {
            line (this.x (tick), top, this.x (tick), top + plotHeight);
            context.fillText (String (Number (tick.toPrecision (10))), this.x (tick), top + plotHeight + 14);
        }

        context.textAlign = "right";

        for (const tick of this.yTicks (plotHeight / 26))
        {
            line (left, this.y (tick), left + plotWidth, this.y (tick));
            context.fillText (this.tickText (tick), left - 6, this.y (tick) + 4);
        }

        context.stroke();
        context.fillText ("Hz", left + plotWidth + 24, top + plotHeight + 2);
        context.save();
        context.translate (12, top + plotHeight / 2);
        context.rotate (-Math.PI / 2);
        context.textAlign = "center";
        context.fillText (this.label, 0, 0);
        context.restore();
    }

    /** A curve of values (n) over ascending frequencies, with gaps where they are not finite or leap further than the given step. */
    curve (frequencies, values, style, { width = 1.5, dash = [], leap = Infinity } = {})
    {
        const { context } = this;
        let last = NaN;
        context.beginPath();
        context.strokeStyle = style;
        context.lineWidth = width;
        context.setLineDash (dash);

        for (let n = firstShown (frequencies, this.range.shown[0]); n < frequencies.length; ++n)
        {
            const value = values (n);
            const goesOn = Number.isFinite (last) && Math.abs (value - last) <= leap;
            last = value;

            if (Number.isFinite (value))
                context[goesOn ? "lineTo" : "moveTo"] (this.x (frequencies[n]), this.y (value));

            if (frequencies[n] > this.range.shown[1])
                break;
        }

        context.stroke();
        context.setLineDash ([]);
    }

    dot (frequency, value, style, radius)
    {
        this.context.fillStyle = style;
        this.context.beginPath();
        this.context.arc (this.x (frequency), this.y (value), radius, 0, 2 * Math.PI);
        this.context.fill();
    }

    /** A line from top to bottom, with a name above it if there is one. */
    marker (frequency, style, { name = "", width = 1, dash = [] } = {})
    {
        const { context } = this;
        context.strokeStyle = context.fillStyle = style;
        context.lineWidth = width;
        context.setLineDash (dash);
        context.beginPath();
        context.moveTo (this.x (frequency), this.top);
        context.lineTo (this.x (frequency), this.top + this.plotHeight);
        context.stroke();
        context.setLineDash ([]);
        context.textAlign = "center";
        context.fillText (name, this.x (frequency), this.top - 5);
    }

    legend (entries)
    {
        const { context } = this;
        context.textAlign = "left";
        let x = this.left + 8;

        for (const [name, style] of entries)
        {
            context.fillStyle = style;
            context.fillRect (x, 6, 14, 3);
            context.fillText (name, x + 19, 12);
            x += context.measureText (name).width + 36;
        }
    }
}

/** The last index whose frequency is below, so that curves enter from outside. */
function firstShown (frequencies, minimum)
{
    let low = 0, high = frequencies.length;

    while (low < high)
    {
        const middle = (low + high) >> 1;
        [low, high] = frequencies[middle] < minimum ? [middle + 1, high] : [low, middle];
    }

    return Math.max (low - 1, 0);
}
