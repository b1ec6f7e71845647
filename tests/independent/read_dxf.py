# SPDX-License-Identifier: MIT
"""What another reader, ezdxf (Debian: python3-ezdxf), finds in a DXF file, as lines of text:

    errors N            found by its audit
    version AC1015
    units 4
    layer NAME COLOUR
    SPLINE LAYER t x y t x y ...      even places of the parameter, by ezdxf's own evaluation
    ARC LAYER cx cy r start end       degrees, counterclockwise
    CIRCLE LAYER cx cy r
    LINE LAYER x y x y
    TEXT LAYER x y height text
    LWPOLYLINE LAYER closed x y x y ...
"""
import sys

import ezdxf

SPLINE_POINTS = 1201


def numbers_of(entity):
    kind = entity.dxftype()
    if kind == "SPLINE":
        curve = entity.construction_tool()
        first, last = curve.knots()[0], curve.knots()[-1]
        places = [first + (last - first) * i / (SPLINE_POINTS - 1) for i in range(SPLINE_POINTS)]
        return [v for t, p in zip(places, curve.points(places)) for v in (t, p.x, p.y)]
    if kind == "ARC":
        d = entity.dxf
        return [d.center.x, d.center.y, d.radius, d.start_angle, d.end_angle]
    if kind == "CIRCLE":
        return [entity.dxf.center.x, entity.dxf.center.y, entity.dxf.radius]
    if kind == "TEXT":
        return [entity.dxf.insert.x, entity.dxf.insert.y, entity.dxf.height]
    if kind == "LINE":
        return [*entity.dxf.start.vec2, *entity.dxf.end.vec2]
    if kind == "LWPOLYLINE":
        return [float(entity.closed)] + [v for p in entity.get_points("xy") for v in p]
    raise SystemExit(f"an entity that nobody asked for: {kind}")


document = ezdxf.readfile(sys.argv[1])
print("errors", len(document.audit().errors) + len(document.audit().fixes))
print("version", document.dxfversion)
print("units", document.header["$INSUNITS"])
for layer in document.layers:
    print("layer", layer.dxf.name, layer.dxf.color)
for entity in document.modelspace():
    words = [entity.dxf.text] if entity.dxftype() == "TEXT" else []
    print(entity.dxftype(), entity.dxf.layer, *(f"{v:.15g}" for v in numbers_of(entity)), *words)
