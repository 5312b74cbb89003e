"""docs/gallery.md: the pictures, and what tools/make-gallery --page writes of them."""

import shutil
import subprocess

from figures import parts

MOST_BYTES = 150_000  # of a picture


def write_picture(ppm, jpeg):
    """The best JPEG file that is small enough."""
    if not shutil.which("cjpeg"):
        raise parts.PageError("cjpeg is missing: run `tools/setup gallery`")
    for quality in range(94, 60, -2):
        command = ["cjpeg", "-quality", str(quality), "-optimize", "-progressive", ppm]
        picture = subprocess.run(command, capture_output=True, check=True).stdout
        if len(picture) <= MOST_BYTES:
            jpeg.write_bytes(picture)
            return
    raise parts.PageError(f"{ppm} is too large as JPEG")


def title(name):
    return name.replace("-", " ").capitalize()


def row(result):
    report, name = result["report"], result["name"]
    scene, sampling = report["scene"], report["sampling"]
    return [f"[{title(name)}](#{name})", f"{scene['triangles'] + scene['meshTriangles']:,}", f"{scene['spheres']:,}",
            str(scene["lights"]),
            f"{sampling['samplesPerPixel']:.1f}", f"{sampling['mostSamplesPerPixel']:,}",
            f"{sum(report['rays'][kind] for kind in ('camera', 'shadow', 'mirror')) / 1e6:,.0f}",
            f"{result['processorSeconds']:.0f}"]


def written(results):
    """The page's part, in Markdown."""
    lines = []
    for result in results:
        name = result["name"]
        lines += [f"## {title(name)}", "", f"![{title(name)}](gallery/{name}.jpg)", "", result["text"], "",
                  "```sh not run: it takes minutes", f"tools/make-gallery {name}", "```", ""]
    header = ["scene", "triangles", "spheres", "lights", "samples a pixel, mean", "most", "million rays", "CPU seconds"]
    picture, device = results[0]["report"]["picture"], results[0]["report"]["device"]
    how = f"{picture['width']} x {picture['height']} pixels with `{' '.join(results[0]['options'])}`"
    lines += ["## What they took", "", parts.markdown_table(header, map(row, results)), "",
              parts.origin("tools/make-gallery --page", how, device["driver"])]
    return "\n".join(lines)


def write(docs, results):
    (docs / "gallery").mkdir(exist_ok=True)
    for result in results:
        write_picture(result["picture"], docs / "gallery" / f"{result['name']}.jpg")
    parts.replace(docs / "gallery.md", "gallery", written(results))
