# SPDX-License-Identifier: MIT
"""The library's figures, drawn by matplotlib."""

from typing import Any

from .errors import MissingPackage

_MARKERS = {"circle": "o", "diamond": "D", "square": "s", "cross": "x"}


def pyplot() -> Any:
    """matplotlib.pyplot. Raises MissingPackage."""
    try:
        import matplotlib.pyplot
    except ImportError as error:
        raise MissingPackage("plots need matplotlib, which is not installed: pip install matplotlib") from error
    return matplotlib.pyplot


def _title(axis: dict[str, Any]) -> str:
    return f"{axis['label']}, {axis['unit']}" if axis["unit"] else str(axis["label"])


def _draw_panel(panel: dict[str, Any], axes: Any, equal: bool) -> None:
    for line in panel["lines"]:
        style = "--" if line["dashed"] else "-"
        axes.plot(
            line["x"],
            line["y"],
            style,
            color=line["colour"] or None,
            linewidth=0.8 * line["width"],
            label=line["name"] or None,
        )
    for some in panel["markers"]:
        shape = _MARKERS[some["shape"]]
        axes.plot(
            some["x"],
            some["y"],
            shape,
            markersize=1.3 * some["size"],
            color=some["colour"] or None,
            fillstyle="full" if some["filled"] else "none",
            label=some["name"] or None,
        )
        for x, y, label in zip(some["x"], some["y"], some["labels"], strict=True):
            if label:
                place = {"xytext": (4, 4), "textcoords": "offset points"}
                axes.annotate(label, (x, y), fontsize=8, **place)
    axes.set_title(panel["title"], fontsize=10)
    axes.set_xlabel(_title(panel["x"]))
    axes.set_ylabel(_title(panel["y"]))
    if equal:
        axes.set_aspect("equal", adjustable="datalim")
    elif panel["x"]["lower"] is not None:
        axes.set_xlim(panel["x"]["lower"], panel["x"]["upper"])
    if not equal and panel["y"]["lower"] is not None:
        axes.set_ylim(panel["y"]["lower"], panel["y"]["upper"])
    axes.grid(True, alpha=0.3)
    drawn, names = axes.get_legend_handles_labels()
    if names:
        once = dict(zip(reversed(names), reversed(drawn), strict=True))
        axes.legend(once.values(), once.keys(), fontsize=8)


def draw(figure: dict[str, Any], equal: bool = False) -> Any:
    """Draws a figure; returns its axes, one or an array. `equal`: both axes to the same scale."""
    plt = pyplot()
    panels = figure["panels"]
    columns = max(1, min(figure["columns"], len(panels)))
    rows = max(1, -(-len(panels) // columns))
    shared = columns == 1 and rows > 1
    drawn, axes = plt.subplots(
        rows,
        columns,
        squeeze=False,
        sharex=shared,
        layout="constrained",
        figsize=(6.4 * columns, 4.8 if rows == 1 else 2.2 * rows + 0.8),
    )
    flat = list(axes.flat)
    for panel, place in zip(panels, flat):
        _draw_panel(panel, place, equal)
        if shared and place is not flat[len(panels) - 1]:
            place.set_xlabel("")
    for place in flat[len(panels) :]:
        place.set_visible(False)
    drawn.suptitle("\n".join(filter(None, (figure["title"], figure["subtitle"]))), fontsize=11)
    return flat[0] if len(flat) == 1 else axes[:, 0] if columns == 1 else axes
