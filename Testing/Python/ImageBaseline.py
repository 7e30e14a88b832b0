# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares images with the baselines in Testing/Baseline, as Testing/Cxx/Images/ImageTest.h does."""

import os

from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

BASELINES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Baseline")
# Drivers differ in which pixels an edge or a letter covers.
TOLERANCE = 15.0


def read_image(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def difference(image, name):
    """The difference of a vtkImageData from the baseline, summed over the pixels with threshold 16: about the number
    of pixels of quite another colour."""
    expected = read_image(os.path.join(BASELINES, name + ".png"))
    assert image.GetDimensions() == expected.GetDimensions(), (image.GetDimensions(), expected.GetDimensions())
    compare = vtkImageDifference()
    compare.SetInputData(image)
    compare.SetImageData(expected)
    compare.SetThreshold(16)
    compare.Update()
    return compare.GetThresholdedError()


def expect_baseline(path, name, tolerance=TOLERANCE):
    """The PNG file looks like the baseline. If the environment has WRITE_BASELINES, it becomes the baseline."""
    image = read_image(path)
    if os.environ.get("WRITE_BASELINES"):
        writer = vtkPNGWriter()
        writer.SetFileName(os.path.join(BASELINES, name + ".png"))
        writer.SetInputData(image)
        writer.Write()
    found = difference(image, name)
    assert found < tolerance, f"{path} differs from the baseline {name} by {found}"


def expect_not_baseline(path, name, wrong, tolerance=TOLERANCE):
    """The image of a wrong result differs from the baseline by at least six times the tolerance."""
    found = difference(read_image(path), name)
    print(f"{name}, {wrong}: {found:.0f}")
    assert found >= 6.0 * tolerance, f"{wrong} does not show: {found}"
