// What mouse, wheel and keys do on a chart.

class Pointer
{
    constructor (plot)
    {
        this.plot = plot;
        const { canvas, range } = plot;
        canvas.addEventListener ("pointerdown", (event) => this.press (event));
        canvas.addEventListener ("pointermove", (event) => this.move (event));
        canvas.addEventListener ("pointerup", (event) => this.release (event));
        canvas.addEventListener ("pointercancel", () => { this.start = null; range.show (...range.shown); });
        canvas.addEventListener ("dblclick", () => range.show (...range.whole));
        canvas.addEventListener ("wheel", (event) => this.turn (event), { passive: false });
        canvas.addEventListener ("keydown", (event) => this.key (event));
    }

    press (event)
    {
        if (event.button !== 0)
            return;

        this.start = { x: event.offsetX, shown: [...this.plot.range.shown], moves: event.shiftKey };
        this.plot.canvas.setPointerCapture (event.pointerId);
    }

    isDrag (event) { return this.start && Math.abs (event.offsetX - this.start.x) > 4; }

    move (event)
    {
        const { plot, start } = this;
        plot.onHover?.(plot.frequencyAt (event.offsetX));

        if (! this.isDrag (event))
            return;

        if (start.moves)
        {
            const step = (start.x - event.offsetX) / plot.plotWidth * (start.shown[1] - start.shown[0]);
            plot.range.show (start.shown[0] + step, start.shown[1] + step);
            return;
        }

        plot.draw();
        plot.context.globalAlpha = 0.2;
        plot.context.fillStyle = colour ("accent");
        plot.context.fillRect (Math.min (start.x, event.offsetX), plot.top, Math.abs (event.offsetX - start.x), plot.plotHeight);
    }

    release (event)
    {
        const { plot, start } = this;
        const isDrag = this.isDrag (event);
        this.start = null;

        if (start && isDrag && ! start.moves)
            plot.range.show (plot.frequencyAt (Math.min (start.x, event.offsetX)), plot.frequencyAt (Math.max (start.x, event.offsetX)));
        else if (start && ! isDrag)
            plot.onClick?.(event.offsetX, event.offsetY);
    }

    turn (event)
    {
        if (! event.ctrlKey && ! event.metaKey) // The page scrolls.
            return;

        event.preventDefault();
        this.plot.range.zoom (1.002 ** event.deltaY, this.plot.frequencyAt (event.offsetX));
    }

    key (event)
    {
        const { range } = this.plot;
        const actions = {
            "+": () => range.zoom (0.5), "-": () => range.zoom (2), "0": () => range.show (...range.whole),
            ArrowLeft: () => range.move (-0.25), ArrowRight: () => range.move (0.25)
        };

        if (! actions[event.key] || event.ctrlKey || event.metaKey || event.altKey)
            return;

        event.preventDefault();
        actions[event.key]();
    }
}
