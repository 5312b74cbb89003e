"""Log-log plots, a panel per scene: as SVG without any library, as PNG with matplotlib."""

import importlib.util
import math
from html import escape

COLUMNS = 3
PANEL_WIDTH, PANEL_HEIGHT = 300, 230
LEFT, RIGHT, TOP, BOTTOM = 52, 12, 26, 38  # of a panel, around its axes
HEAD = 56  # of the page: title and legend

# Told apart by shape as well as colour; the colours are Okabe and Ito's, which the colour-blind can tell apart.
STYLES = {
    "random": ("#D55E00", "square", "fixed, random"),
    "sobol": ("#0072B2", "circle", "fixed, Owen-Sobol"),
    "adaptive": ("#009E73", "triangle", "adaptive"),
    "povray-am1": ("#CC79A7", "diamond", "POV-Ray +AM1"),
    "povray-am2": ("#E69F00", "wedge", "POV-Ray +AM2"),
}


class Axis:
    """Maps logarithms of values onto a length in pixels. Powers of ten are ticks; the fewer there are, the more of
    their multiples are ticks as well."""

    def __init__(self, values, start, end):
        low, high = math.log10(min(values)), math.log10(max(values))
        margin = max(0.05 * (high - low), 0.05)
        self.low, self.high = low - margin, high + margin
        self.start, self.end = start, end

    def at(self, value):
        part = (math.log10(value) - self.low) / (self.high - self.low)
        return self.start + part * (self.end - self.start)

    def ticks(self):
        decades = self.high - self.low
        finest = (1, 1.5, 2, 3, 4, 5, 7)
        steps = (1,) if decades > 3.5 else (1, 3) if decades > 1.7 else (1, 2, 5) if decades > 0.7 else finest
        exponents = range(math.floor(self.low), math.ceil(self.high) + 1)
        candidates = [step * 10.0**exponent for exponent in exponents for step in steps]
        return [tick for tick in candidates if self.low <= math.log10(tick) <= self.high]


def tick_label(value):
    return f"{value:g}" if 1e-3 <= value < 1e5 else f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e")


def svg(title, x_label, panels, styles=STYLES, y_label="RMSE"):
    """`panels`: (name, {method: [(x, y)]}, x of a dashed line or None). Each method needs a style."""
    rows = math.ceil(len(panels) / COLUMNS)
    width, height = COLUMNS * PANEL_WIDTH, HEAD + rows * PANEL_HEIGHT
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
        ' font-family="Helvetica, Arial, sans-serif" font-size="11" fill="#333">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
        f'<text x="12" y="22" font-size="15" font-weight="bold">{escape(title)}</text>',
        *legend(panels, styles),
    ]
    for index, (name, curves, line) in enumerate(panels):
        x, y = index % COLUMNS * PANEL_WIDTH, HEAD + index // COLUMNS * PANEL_HEIGHT
        parts += [f'<g transform="translate({x} {y})">', *panel(name, (x_label, y_label), curves, line, styles), "</g>"]
    return "\n".join([*parts, "</svg>"]) + "\n"


def legend(panels, styles):
    parts = []
    x = 24
    for method, (color, shape, label) in styles.items():
        if any(curves.get(method) for _, curves, _ in panels):
            parts.append(f'<path d="M{x - 12} 40H{x + 12}" stroke="{color}" stroke-width="1.6"/>')
            parts += [marker(shape, x, 40, color), f'<text x="{x + 17}" y="44">{label}</text>']
            x += 50 + 6 * len(label)
    if any(line for _, _, line in panels):
        parts.append(f'<path d="M{x - 12} 40H{x + 12}" stroke="#999" stroke-dasharray="4 3"/>')
        parts.append(f'<text x="{x + 17}" y="44">one sample a pixel: mostly start-up</text>')
    return parts


def panel(name, labels, curves, line, styles):
    points = [point for curve in curves.values() for point in curve]
    left, right, top, bottom = LEFT, PANEL_WIDTH - RIGHT, TOP, PANEL_HEIGHT - BOTTOM
    parts = [f'<text x="{left}" y="{top - 8}" font-weight="bold">{escape(name)}</text>']
    if not points:
        return parts
    x_axis = Axis([x for x, _ in points] + ([line] if line else []), left, right)
    y_axis = Axis([y for _, y in points], bottom, top)
    for tick in x_axis.ticks():
        x = x_axis.at(tick)
        parts.append(f'<path d="M{x:.1f} {top}V{bottom}" stroke="#e6e6e6"/>')
        parts.append(f'<text x="{x:.1f}" y="{bottom + 14}" text-anchor="middle">{tick_label(tick)}</text>')
    for tick in y_axis.ticks():
        y = y_axis.at(tick)
        parts.append(f'<path d="M{left} {y:.1f}H{right}" stroke="#e6e6e6"/>')
        parts.append(f'<text x="{left - 5}" y="{y + 4:.1f}" text-anchor="end">{tick_label(tick)}</text>')
    parts.append(f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" fill="none" '
                 'stroke="#888"/>')
    middle, center = (left + right) / 2, (top + bottom) / 2
    parts.append(f'<text x="{middle}" y="{bottom + 29}" text-anchor="middle">{escape(labels[0])}</text>')
    parts.append(f'<text transform="translate(12 {center}) rotate(-90)" text-anchor="middle">{escape(labels[1])}</text>')
    if line:
        parts.append(f'<path d="M{x_axis.at(line):.1f} {top}V{bottom}" stroke="#999" stroke-dasharray="4 3"/>')
    for method, curve in curves.items():
        color, shape, _ = styles[method]
        places = [(x_axis.at(x), y_axis.at(y)) for x, y in curve]
        if places:
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
            parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="1.6"/>')
        parts += [marker(shape, x, y, color) for x, y in places]
    return parts


def marker(shape, x, y, color):
    if shape == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.2" fill="{color}"/>'
    if shape == "square":
        return f'<rect x="{x - 2.9:.1f}" y="{y - 2.9:.1f}" width="5.8" height="5.8" fill="{color}"/>'
    outlines = {"triangle": (-4.2, "l3.9 6.8h-7.8z"), "wedge": (4.2, "l3.9 -6.8h-7.8z"),
                "diamond": (-4.2, "l3.9 4.2l-3.9 4.2l-3.9 -4.2z")}
    offset, outline = outlines[shape]
    return f'<path d="M{x:.1f} {y + offset:.1f}{outline}" fill="{color}"/>'


def matplotlib_is_available():
    return importlib.util.find_spec("matplotlib") is not None


def write_png(path, title, x_label, panels):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    rows = math.ceil(len(panels) / COLUMNS)
    figure, grid = pyplot.subplots(rows, COLUMNS, figsize=(4 * COLUMNS, 3 * rows), squeeze=False,
                                   layout="constrained")
    markers = {"square": "s", "circle": "o", "triangle": "^", "wedge": "v", "diamond": "D"}
    for axes in grid.flat[len(panels):]:
        axes.axis("off")
    for axes, (name, curves, line) in zip(grid.flat, panels):
        for method, curve in curves.items():
            color, shape, label = STYLES[method]
            if curve:
                axes.loglog(*zip(*curve), color=color, marker=markers[shape], markersize=4, label=label)
        if line:
            axes.axvline(line, color="#999999", linestyle="--", linewidth=1)
        axes.set(title=name, xlabel=x_label, ylabel="RMSE")
        axes.grid(alpha=0.3)
    max(grid.flat, key=lambda axes: len(axes.lines)).legend(fontsize="small")
    figure.suptitle(title)
    figure.savefig(path, dpi=120)
    pyplot.close(figure)
