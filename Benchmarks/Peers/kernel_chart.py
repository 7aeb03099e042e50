"""The kernels' chart as SVG: bars of nanoseconds, and lines of the share of the processor's limit. Written by hand, no package needed."""

import math

STYLE = """
  text { font: 13px "DejaVu Sans", Verdana, sans-serif; fill: #24292f; }
  .small { font-size: 11px; fill: #57606a; }
  .title { font-size: 14px; font-weight: bold; }
  .grid { stroke: #d0d7de; stroke-width: 1; }
  .bar { fill: #8c959f; }
  .ours { fill: #0969da; }
  .line { fill: none; stroke-width: 2; }
  .c0 { stroke: #9ecae1; fill: #9ecae1; } .c1 { stroke: #4292c6; fill: #4292c6; }
  .c2 { stroke: #08519c; fill: #08519c; } .c3 { stroke: #d95f02; fill: #d95f02; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3; } .small { fill: #9198a1; } .grid { stroke: #3d444d; } .ours { fill: #4493f8; }
    .c2 { stroke: #7a9fd8; fill: #7a9fd8; }
  }
"""


def text(x, y, words, css="", anchor="start"):
    return f'<text x="{x:.1f}" y="{y:.1f}" class="{css}" text-anchor="{anchor}">{words}</text>'


def bars(left, top, width, values):
    """values: (name, nanoseconds); the first is ours."""
    label, height, step = 190, 16, 26
    scale = (width - label - 50) / max(value for _, value in values)
    parts = [text(left, top, "Bank of 64 modes, one input, one output: ns a mode-sample", "title")]

    for i, (name, value) in enumerate(values):
        y = top + 18 + i * step
        parts += [text(left + label - 8, y + 12, name, "", "end"),
                  f'<rect x="{left + label}" y="{y}" width="{scale * value:.1f}" height="{height}" class="{"bar" if i else "ours"}"/>',
                  text(left + label + scale * value + 6, y + 12, f"{value:.2f}", "small")]

    return parts


def apart(heights, least):
    """Heights from top to bottom, moved so that each is at least so far below the one before."""
    moved = []

    for height in heights:
        moved.append(max(height, moved[-1] + least) if moved else height)

    return moved


def lines(left, top, width, title, sizes, series):
    """series: (name, shares at the sizes, 0 to 1)."""
    height, right = 180, 100
    octaves = lambda size: math.log2(size / sizes[0])
    x = lambda i: left + 34 + octaves(sizes[i]) / octaves(sizes[-1]) * (width - 34 - right)
    y = lambda share: top + 18 + (1 - share) * height
    parts = [text(left, top, title, "title")]

    for percent in (0, 25, 50, 75, 100):
        parts += [f'<line x1="{x(0)}" x2="{x(len(sizes) - 1):.1f}" y1="{y(percent / 100)}" y2="{y(percent / 100)}" class="grid"/>',
                  text(x(0) - 6, y(percent / 100) + 4, f"{percent} %", "small", "end")]

    parts += [text(x(i), y(0) + 16, size, "small", "middle") for i, size in enumerate(sizes)]
    ends = sorted(range(len(series)), key=lambda i: -series[i][1][-1])
    heights = dict(zip(ends, apart([y(series[i][1][-1]) for i in ends], 14)))

    for i, (name, shares) in enumerate(series):
        points = " ".join(f"{x(k):.1f},{y(share):.1f}" for k, share in enumerate(shares))
        parts += [f'<polyline points="{points}" class="line c{i}" style="fill: none"/>']
        parts += [f'<circle cx="{x(k):.1f}" cy="{y(share):.1f}" r="3" class="c{i}"/>' for k, share in enumerate(shares)]
        parts += [f'<circle cx="{x(len(sizes) - 1) + 14:.1f}" cy="{heights[i]:.1f}" r="3" class="c{i}"/>',
                  text(x(len(sizes) - 1) + 22, heights[i] + 4, name, "small")]

    return parts + [text((x(0) + x(len(sizes) - 1)) / 2, y(0) + 32, "modes", "small", "middle")]


def chart(peers, sizes, synthesis, plate):
    """peers: (name, ns); sizes: modes; synthesis, plate: (name, shares at the sizes)."""
    below = 60 + 26 * len(peers) + 20
    parts = bars(20, 30, 820, peers)
    parts += lines(20, below, 400, "Synthesis, share of the FMA limit", sizes, synthesis)
    parts += lines(440, below, 400, "Plate with 16 probes, share of the FMA limit", sizes, plate)
    size = f'width="860" height="{below + 250}" viewBox="0 0 860 {below + 250}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}>\n<style>{STYLE}</style>\n' + "\n".join(parts) + "\n</svg>\n"
