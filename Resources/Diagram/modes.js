// The modes: which poles are picked, the option that says so, and the responses that follow from the modes.

/** Candidates for modes. Each has a frequency in Hz, a damping ratio, a presence, maybe the number of a fitted mode. */
class Picks
{
    constructor (candidates)
    {
        this.candidates = candidates.map ((candidate) => ({ ...candidate, isPicked: candidate.mode !== null }));
        this.listeners = [];
    }

    get picked() { return this.candidates.filter ((candidate) => candidate.isPicked); }
    get changed() { return this.candidates.filter ((candidate) => candidate.isPicked !== (candidate.mode !== null)); }

    nearest (frequency, candidates = this.candidates)
    {
        return candidates.reduce ((best, other) => ! best || Math.abs (other.frequency - frequency)
                                                                     < Math.abs (best.frequency - frequency) ? other : best, null);
    }

    set (candidates, isPicked)
    {
        for (const candidate of candidates)
            candidate.isPicked = isPicked (candidate);

        for (const listener of this.listeners)
            listener();
    }

    /** As few decimals as tell the program which candidate is meant: it takes the nearest. */
    text (candidate)
    {
        for (let decimals = 2; decimals < 9; ++decimals)
            if (this.nearest (Number (candidate.frequency.toFixed (decimals))) === candidate)
                return candidate.frequency.toFixed (decimals);

        return candidate.frequency.toFixed (9);
    }

    /** The option of antinode identify. */
    get line() { return this.picked.length === 0 ? "" : "--select " + this.picked.map ((candidate) => this.text (candidate)).join (","); }
}

/** The fitted modes at the lines of the page. */
class Synthesis
{
    constructor (data, frequencies)
    {
        this.modes = data.modes;
        this.delay = data.delay;
        this.omega = frequencies.map ((frequency) => 2 * Math.PI * frequency);
        this.points = data.points.names.length;
        this.shape = data.modes.map ((mode) => floatsOf (mode.shape));
        this.shapeImaginary = data.modes.map ((mode) => mode.shapeImaginary ? floatsOf (mode.shapeImaginary) : null);
        this.participation = data.modes.map ((mode) => floatsOf (mode.participation));
        this.participationImaginary = data.modes.map ((mode) => mode.participationImaginary ? floatsOf (mode.participationImaginary) : null);
        this.residuals = data.residuals.map (({ power, coefficients }) => ({ power, coefficients: floatsOf (coefficients) }));
        this.lowPasses = floatsOf (data.lowPasses);
    }

    /** A mode's complex product of shape and participation. */
    product (mode, point, reference)
    {
        const a = this.shape[mode][point], b = this.shapeImaginary[mode]?.[point] ?? 0;
        const c = this.participation[mode][reference], d = this.participationImaginary[mode]?.[reference] ?? 0;
        return [a * c - b * d, a * d + b * c];
    }

    /** One response of those modes for which isKept (mode) holds. Docs/Theory.md, section 8.1. */
    response (point, reference, isKept)
    {
        const real = new Float64Array (this.omega.length), imaginary = new Float64Array (this.omega.length);
        this.modes.forEach ((mode, k) => isKept (k) && this.addMode (real, imaginary, mode, this.product (k, point, reference)));

        for (const { power, coefficients } of this.residuals)
            this.addPower (real, imaginary, power, coefficients[reference * this.points + point]);

        for (let f = 0; f < this.omega.length; ++f)
        {
            const cosine = Math.cos (this.omega[f] * this.delay), sine = -Math.sin (this.omega[f] * this.delay);
            [real[f], imaginary[f]] = [real[f] * cosine - imaginary[f] * sine, real[f] * sine + imaginary[f] * cosine];
        }

        this.addLowPass (real, imaginary, this.lowPasses[reference * this.points + point] ?? 0);
        return { real, imaginary };
    }

    /** The product c = a + i b gives r / (i omega - s) and its conjugate, r = c s / (s - conj (s)). Their sum has the numerator
        i omega a - b (omega_k + i xi omega) / sqrt (1 - xi^2) over omega_k^2 - omega^2 + 2 i xi omega_k omega. */
    addMode (real, imaginary, mode, [a, b])
    {
        const resonance = 2 * Math.PI * mode.frequency, ratio = mode.damping;
        const skew = -b / Math.sqrt (1 - ratio * ratio);

        for (let f = 0; f < this.omega.length; ++f)
        {
            const omega = this.omega[f];
            const x = resonance * resonance - omega * omega, y = 2 * ratio * resonance * omega;
            const u = skew * resonance, v = (a + skew * ratio) * omega;
            const square = x * x + y * y;
            real[f] += (u * x + v * y) / square;
            imaginary[f] += (v * x - u * y) / square;
        }
    }

    /** Of first order. @param timeConstant  s */
    addLowPass (real, imaginary, timeConstant)
    {
        for (let f = 0; f < this.omega.length; ++f)
        {
            const x = timeConstant * this.omega[f], square = 1 + x * x;
            [real[f], imaginary[f]] = [(real[f] + imaginary[f] * x) / square, (imaginary[f] - real[f] * x) / square];
        }
    }

    addPower (real, imaginary, power, coefficient)
    {
        const quarter = ((power % 4) + 4) % 4;
        const sign = quarter < 2 ? 1 : -1;
        const target = quarter % 2 === 0 ? real : imaginary;

        for (let f = 0; f < this.omega.length; ++f)
            if (this.omega[f] > 0 || power >= 0)
                target[f] += sign * coefficient * this.omega[f] ** power;
    }
}
