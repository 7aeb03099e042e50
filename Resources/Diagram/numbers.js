// Numbers as the page holds them, and as it writes them.

/** Bytes of a base64 text. */
function bytesOf (text)
{
    const raw = atob (text);
    const bytes = new Uint8Array (raw.length);

    for (let n = 0; n < raw.length; ++n)
        bytes[n] = raw.charCodeAt (n);

    return bytes;
}

const floatsOf = (text) => new Float32Array (bytesOf (text).buffer);
const doublesOf = (text) => new Float64Array (bytesOf (text).buffer);

/** Complex numbers of two bytes each: a level below the largest in half decibels (0: the number is 0, 255: none was
    measured), and an angle in 256 parts of a turn. */
function complexOf (text, largest)
{
    const bytes = bytesOf (text);
    const real = new Float64Array (bytes.length / 2), imaginary = new Float64Array (bytes.length / 2);

    for (let n = 0; n < real.length; ++n)
    {
        const level = bytes[2 * n], angle = bytes[2 * n + 1] * Math.PI / 128;
        const size = level === 255 ? NaN : level === 0 ? 0 : largest * 10 ** ((level - 254) / 40);
        real[n] = size * Math.cos (angle);
        imaginary[n] = size * Math.sin (angle);
    }

    return { real, imaginary };
}

/** A number with so many digits that count, without exponents where they can be avoided. */
function written (value, digits)
{
    if (! Number.isFinite (value))
        return "-";

    const size = Math.abs (value);
    return size >= 1e6 || (size < 1e-3 && size > 0) ? value.toExponential (digits - 1) : String (Number (value.toPrecision (digits)));
}

const decibels = (ratio) => 20 * Math.log10 (Math.max (ratio, 1e-12));

/** Round steps between two numbers, about so many. */
function ticksBetween (minimum, maximum, count)
{
    const raw = (maximum - minimum) / Math.max (count, 1);
    const power = 10 ** Math.floor (Math.log10 (raw));
    const step = [1, 2, 5, 10].map ((factor) => factor * power).find ((candidate) => candidate >= raw);
    const ticks = [];

    for (let n = Math.ceil (minimum / step - 1e-9); n * step <= maximum + 1e-9 * step; ++n)
        ticks.push (n * step);

    return ticks;
}
