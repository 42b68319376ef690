# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the files of a catalogue with nothing of ours: QuakeML and VTK XML by ElementTree, CSV by csv. Numbers as text."""
import base64
import csv
import struct
import xml.etree.ElementTree as ElementTree

BED = "{http://quakeml.org/xmlns/bed/1.2}"
OWN = "{urn:fissura:catalogue:1}"
ROOT = "{http://quakeml.org/xmlns/quakeml/1.2}quakeml"
AXES = ("tAxis", "pAxis", "nAxis")
TENSOR = ("Mrr", "Mtt", "Mpp", "Mrt", "Mrp", "Mtp")


def rows(file):
    with open(file, newline="", encoding="utf-8") as text:
        return list(csv.DictReader(text))


def at(element, *path):
    """The one element at a path of names; None if there is none."""
    for name in path:
        found = element.findall(BED + name)
        assert len(found) <= 1, f"{len(found)} elements {name}"
        if not found:
            return None
        element = found[0]
    return element


def text(element, *path):
    found = at(element, *path)
    return None if found is None else found.text


def value(element, *path):
    """The text of a quantity."""
    return text(element, *path, "value")


def quakeml_event(event):
    tensor = at(event, "focalMechanism", "momentTensor")
    found = {"publicID": event.get("publicID"), "type": text(event, "type"), "typeCertainty": text(event, "typeCertainty"),
             "origin": at(event, "origin").get("publicID"), "preferredOriginID": text(event, "preferredOriginID"),
             "preferredMagnitudeID": text(event, "preferredMagnitudeID"),
             "preferredFocalMechanismID": text(event, "preferredFocalMechanismID"),
             "mechanism": at(event, "focalMechanism").get("publicID"),
             "time": value(event, "origin", "time"), "originType": text(event, "origin", "type"),
             "depthType": text(event, "origin", "depthType"), "evaluationMode": text(event, "origin", "evaluationMode"),
             "lat": value(event, "origin", "latitude"), "lon": value(event, "origin", "longitude"),
             "depth_m": value(event, "origin", "depth"),
             "derivedOriginID": text(tensor, "derivedOriginID"), "momentMagnitudeID": text(tensor, "momentMagnitudeID"),
             "M0_Nm": value(tensor, "scalarMoment"), "doubleCouple": text(tensor, "doubleCouple"),
             "clvd": text(tensor, "clvd"), "iso": text(tensor, "iso"), "inversionType": text(tensor, "inversionType"),
             "functionType": text(tensor, "sourceTimeFunction", "type"),
             "duration": text(tensor, "sourceTimeFunction", "duration"),
             "tensor": [value(tensor, "tensor", name) for name in TENSOR],
             "own": {child.tag[len(OWN):]: child.text for child in event if child.tag.startswith(OWN)}}
    magnitude = at(event, "magnitude")
    if magnitude is not None:
        planes = at(event, "focalMechanism", "nodalPlanes")
        found |= {"magnitude": magnitude.get("publicID"), "Mw": value(magnitude, "mag"), "magnitudeType": text(magnitude, "type"),
                  "magnitudeOrigin": text(magnitude, "originID"), "preferredPlane": planes.get("preferredPlane"),
                  "planes": [[value(planes, plane, angle) for angle in ("strike", "dip", "rake")]
                             for plane in ("nodalPlane1", "nodalPlane2")],
                  "axes": [[value(event, "focalMechanism", "principalAxes", axis, part) for part in ("azimuth", "plunge", "length")]
                           for axis in AXES]}
    return found


def quakeml(file):
    """Parameters element and list of events."""
    root = ElementTree.parse(file).getroot()
    assert root.tag == ROOT, root.tag
    parameters = at(root, "eventParameters")
    return parameters, [quakeml_event(event) for event in parameters.findall(BED + "event")]


FORMATS = {"Float64": "d", "Int64": "q", "UInt64": "Q", "UInt8": "B"}


def array(element):
    """Values of a DataArray, one tuple a row if it has several components."""
    content = base64.b64decode(element.text, validate=True)
    (length,) = struct.unpack_from("<Q", content)
    assert length == len(content) - 8, (length, len(content))
    letter = FORMATS[element.get("type")]
    values = struct.unpack(f"<{length // struct.calcsize('<' + letter)}{letter}", content[8:])
    width = int(element.get("NumberOfComponents", "1"))
    return list(values) if width == 1 else list(zip(*[iter(values)] * width))


def points(file):
    """Number of points and vertices the file says it has, and all its arrays by name."""
    root = ElementTree.parse(file).getroot()
    assert (root.tag, root.get("type"), root.get("byte_order"), root.get("header_type")) == \
        ("VTKFile", "PolyData", "LittleEndian", "UInt64"), root.attrib
    piece = root.find("PolyData/Piece")
    arrays = {element.get("Name"): array(element) for element in piece.iter("DataArray")}
    return int(piece.get("NumberOfPoints")), int(piece.get("NumberOfVerts")), arrays
