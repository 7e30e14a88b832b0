# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts of the pages of docs/ run as they stand, on a small hill in place of the brain and its scan."""

import contextlib
import io
import os
import re
from pathlib import Path

from paraview import servermanager
from paraview.simple import (
    Calculator,
    ConformalDisk,
    OMTAreaPreserving,
    ResampleToImage,
    SaveData,
    Sphere,
)

docs = Path(__file__).resolve().parents[2] / "docs"
folder = Path(os.environ["TEMPORARY_DIRECTORY"], "page-scripts")
(folder / "demo-output").mkdir(parents=True, exist_ok=True)
os.chdir(folder)

# A half sphere of radius 40 with bumps; region 23 is a strip of it.
ball = Sphere(Radius=40, ThetaResolution=80, PhiResolution=60, EndPhi=90)
radius = "(1 + 0.12*exp(-((coordsX-20)^2 + (coordsY-5)^2)/30) + 0.1*exp(-((coordsX+15)^2 + (coordsY+10)^2)/20))"
hill = Calculator(Input=ball, CoordinateResults=1, Function=f"coords*{radius}")
labelled = Calculator(Input=hill, ResultArrayName="Region", ResultArrayType="Int", Function="5 + 18*(coordsX > 12)")
SaveData("demo-output/flattened.vtp", OMTAreaPreserving(Input=ConformalDisk(Input=labelled)), DataMode="Binary")
block = ResampleToImage(
    Input=Calculator(Input=hill, ResultArrayName="NIFTI", Function="coordsZ"),
    UseInputBounds=0,
    SamplingBounds=[-60, 60, -60, 60, -60, 60],
    SamplingDimensions=[40, 40, 40],
)
SaveData("scan.vti", block, DataMode="Binary")

PLACES = {
    "build/plugins": os.environ["PV_PLUGIN_PATH"],
    "/usr/share/mricron/templates/ch2bet.nii.gz": "scan.vti",
}
SCRIPT = re.compile(r"^## In pvpython\n\n```python\n(.*?)^```", re.MULTILINE | re.DOTALL)


def run(page):
    """Runs the script of the page; returns its printed text and its variables."""
    text = (docs / page).read_text(encoding="utf-8")
    scripts = SCRIPT.findall(text)
    assert len(scripts) == 1, f"{page}: {len(scripts)} scripts under In pvpython"
    script = scripts[0]
    for there, here in PLACES.items():
        script = script.replace(there, here)
    variables = {"__name__": page}
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(script, page, "exec"), variables)
    return printed.getvalue(), variables


def points(proxy):
    return servermanager.Fetch(proxy).GetNumberOfPoints()


text, made = run("area_weights.md")
factor = made["factors"][23] / made["rest"]
assert set(made["factors"]) == {-1, 5, 23} and 3.5 < factor < 4.05, made["factors"]
assert text == f"region 23: {factor:.2f} times as large as the rest\n", text

text, made = run("mesh_saliency.md")
assert re.fullmatch(r"[1-9]\d* regions of [\d.]+ to [\d.]+ mm²\n", text), text
assert points(made["salient"]) == points(made["brain"])

text, made = run("flatten_region.md")
assert [line.split(":")[0] for line in text.splitlines()] == [
    "Area",
    "GreatestDiameter",
    "ExtentAcross",
    "Perimeter",
], text
area, on_map = (float(x) for x in re.match(r"Area: ([\d.]+) ± .*; on the map ([\d.]+)", text).groups())
assert 2000 < area < 4000 and abs(on_map / area - 1) < 0.01, text

text, made = run("context_resolution.md")
assert "FlippedFaces 0.0" in text, text
assert points(made["map_of_coarse"]) > 0

text, made = run("flat_map_slab.md")
assert text.count("grey values") == 4, text
assert Path("slab.vti").stat().st_size > 10000

text, made = run("textures.md")
assert int(text.split()[0]) > 0.7 * 1024 * 1024, text
assert Path("regions.png").stat().st_size > 1000 and "regions.png" in Path("brain.mtl").read_text()

text, made = run("planar_warp.md")
assert text.startswith("OutsidePoints 0.0\nInsertedPoints "), text
bounds = made["magnified"].GetDataInformation().GetBounds()
assert all(abs(x - y) < 1e-6 for x, y in zip(bounds[:4], (0, 1, 0, 1))), bounds
