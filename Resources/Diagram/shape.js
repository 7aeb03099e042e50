// The shape of a mode, moving.

/** Triangles between points that lie in a plane, each as three indices: Bowyer 1981 and Watson 1981. Those with sides much longer than
    most are left out: they bridge what was not measured. */
function trianglesOf (x, y)
{
    const centre = [(Math.min (...x) + Math.max (...x)) / 2, (Math.min (...y) + Math.max (...y)) / 2];
    const size = Math.max (Math.max (...x) - Math.min (...x), Math.max (...y) - Math.min (...y), 1e-9);
    // Shifted a little, so that no four points lie on one circle.
    const points = Array.from (x, (_, n) => [(x[n] - centre[0]) / size + 1e-6 * Math.sin (12.9898 * n),
                                             (y[n] - centre[1]) / size + 1e-6 * Math.cos (78.233 * n)]);
    points.push ([-50, -40], [50, -40], [0, 60]);
    let triangles = [withCircle (points, x.length, x.length + 1, x.length + 2)];

    for (let n = 0; n < x.length; ++n)
    {
        const edges = new Map();
        const isHit = (one) => (points[n][0] - one.x) ** 2 + (points[n][1] - one.y) ** 2 < one.square;

        for (const one of triangles.filter (isHit))
            for (const [a, b] of [[0, 1], [1, 2], [2, 0]])
            {
                const edge = [one.corners[a], one.corners[b]].sort ((p, q) => p - q), key = edge.join();
                edges.set (key, edges.has (key) ? null : edge);
            }

        triangles = triangles.filter ((one) => ! isHit (one));

        for (const edge of edges.values())
            if (edge)
                triangles.push (withCircle (points, edge[0], edge[1], n));
    }

    const kept = triangles.filter ((one) => one.corners.every ((corner) => corner < x.length)).map ((one) => one.corners);
    const length = ([p, q]) => Math.hypot (points[p][0] - points[q][0], points[p][1] - points[q][1]);
    const longest = ([a, b, c]) => Math.max (...[[a, b], [b, c], [c, a]].map (length));
    const lengths = kept.map (longest).sort ((a, b) => a - b);
    return kept.filter ((corners) => longest (corners) < 4 * lengths[lengths.length >> 1]);
}

function withCircle (points, a, b, c)
{
    const [ax, ay] = points[a], bx = points[b][0] - ax, by = points[b][1] - ay, cx = points[c][0] - ax, cy = points[c][1] - ay;
    const twice = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    const x = (cy * b2 - by * c2) / twice, y = (bx * c2 - cx * b2) / twice;
    return { corners: [a, b, c], x: ax + x, y: ay + y, square: x * x + y * y };
}

/** A moving picture of a shape: lines between neighbouring points, dots on the points; the chosen point is large. */
class ShapeView
{
    constructor (canvas, points, onPoint)
    {
        this.canvas = canvas;
        this.x = doublesOf (points.x);
        this.y = doublesOf (points.y);
        const ends = [this.x, this.y].map ((values) => [Math.min (...values), Math.max (...values)]);
        const spans = ends.map (([from, to]) => to - from);
        this.centre = ends.map (([from, to]) => (from + to) / 2);
        this.extent = Math.max (...spans, 1e-9);
        this.isUpright = spans[1] > spans[0];
        this.isPlane = Math.min (...spans) > 1e-3 * this.extent && this.x.length > 3;
        this.turn = 0;
        this.amplitude = 1;
        this.isMoving = ! window.matchMedia ("(prefers-reduced-motion: reduce)").matches;
        this.shape = null;
        this.point = 0;
        canvas.addEventListener ("click", (event) => onPoint (this.pointNear (event.offsetX, event.offsetY)));
        requestAnimationFrame ((time) => this.step (time));
    }

    /** Shapes of real and imaginary parts; the latter may be missing. */
    show (real, imaginary)
    {
        const largest = Math.max (1e-300, ...Array.from (real, (value, n) => Math.hypot (value || 0, imaginary?.[n] || 0)));
        this.shape = { real: Array.from (real, (value) => (value || 0) / largest),
                       imaginary: Array.from (real, (_, n) => (imaginary?.[n] || 0) / largest) };
        this.draw();
    }

    /** Neighbours are found when they are first needed: a page opens without them. */
    get edges()
    {
        if (this.neighbours)
            return this.neighbours;

        const order = Array.from (this.x.keys()).sort ((a, b) => this.x[a] - this.x[b] || this.y[a] - this.y[b]);
        const pairs = this.isPlane ? trianglesOf (this.x, this.y).flatMap (([a, b, c]) => [[a, b], [b, c], [c, a]])
                                   : order.slice (1).map ((point, n) => [order[n], point]);
        const unique = new Map (pairs.map (([a, b]) => [Math.min (a, b) + "," + Math.max (a, b), [a, b]]));
        return this.neighbours = [...unique.values()];
    }

    step (time)
    {
        if (this.isMoving && this.shape)
        {
            this.turn = time / 1600;
            this.draw();
        }

        requestAnimationFrame ((next) => this.step (next));
    }

    displacement (n)
    {
        const angle = 2 * Math.PI * this.turn;
        return this.shape ? this.shape.real[n] * Math.cos (angle) - this.shape.imaginary[n] * Math.sin (angle) : 0;
    }

    /** Where a point is on the canvas: seen from above at an angle, or from the side. */
    place (n, width, height)
    {
        const u = (this.x[n] - this.centre[0]) / this.extent, v = (this.y[n] - this.centre[1]) / this.extent;
        const scale = (width - 40) * (this.isPlane ? 0.78 : 0.96);
        const lift = this.amplitude * this.displacement (n);
        return this.isPlane ? [width / 2 + scale * (0.9 * u + 0.35 * v), height / 2 - scale * (0.45 * v - 0.12 * u) - 0.14 * height * lift]
                            : [width / 2 + scale * (this.isUpright ? v : u), height / 2 - 0.3 * height * lift];
    }

    draw()
    {
        const { context, width, height } = cleared (this.canvas);
        this.places = Array.from (this.x, (_, n) => this.place (n, width, height));
        context.strokeStyle = colour ("measured");
        context.lineWidth = 0.8;
        context.beginPath();

        for (const [a, b] of this.edges)
        {
            context.moveTo (...this.places[a]);
            context.lineTo (...this.places[b]);
        }

        context.stroke();
        this.places.forEach (([x, y], n) => {
            const lift = this.displacement (n);
            context.globalAlpha = 0.35 + 0.65 * Math.min (Math.abs (lift), 1);
            context.fillStyle = colour (lift >= 0 ? "accent" : "warn");
            context.beginPath();
            context.arc (x, y, n === this.point ? 7 : 3, 0, 2 * Math.PI);
            context.fill();
        });
        context.globalAlpha = 1;
    }

    pointNear (x, y)
    {
        const distances = this.places.map (([px, py]) => Math.hypot (px - x, py - y));
        return distances.indexOf (Math.min (...distances));
    }
}
