#!/usr/bin/env python3
"""Draws docs/door.svg: a door that opens, by sclerp, and by lerp of its translation with slerp of its rotation.

    door_picture.py COMMAND... > docs/door.svg    COMMAND is how `swivel` is called
"""

import math
import subprocess
import sys

WIDTH, HINGE, OPEN = 0.8, (2.0, 1.0), math.radians(120)
STEPS = 5
THICK = 0.035

LEFT, RIGHT, BOTTOM, TOP = 1.12, 3.28, 0.62, 1.98  # of the picture, in metres
SCALE = 340
INK, WALL, PATH, DOOR, OTHER = "#24292f", "#c9ced6", "#0b5cad", "#a9cdf0", "#c2410c"


def evaluate(command, operation, header, table):
    """The rows that `swivel eval` makes of these."""
    text = header + "\n" + "".join(" ".join(repr(x) for x in row) + "\n" for row in table)
    result = subprocess.run([*command, "eval", operation, "--precision", "reproducible"] +
                            (["--t", "column"] if header.endswith(" t") else []),
                            input=text, stdout=subprocess.PIPE, text=True, check=True)
    return [tuple(float(x) for x in line.split(",")) for line in result.stdout.splitlines()[1:]]


def pose(angle):
    """Rotation and translation of the door, whose origin is in its middle."""
    return ((0.0, 0.0, math.sin(angle / 2), math.cos(angle / 2)),
            (HINGE[0] + WIDTH / 2 * math.cos(angle), HINGE[1] + WIDTH / 2 * math.sin(angle), 0.0))


def by_sclerp(command, parameters):
    poses = [q + t for q, t in (pose(0), pose(OPEN))]
    a, b = evaluate(command, "from_rotation_translation", "qx qy qz qw tx ty tz", poses)
    header = "ax ay az aw adx ady adz adw bx by bz bw bdx bdy bdz bdw t"
    motors = evaluate(command, "sclerp", header, [a + b + (t,) for t in parameters])
    rows = evaluate(command, "to_rotation_translation", "mx my mz mw mdx mdy mdz mdw", motors)
    return [(row[:4], row[4:]) for row in rows]


def by_lerp_and_slerp(command, parameters):
    (qa, ta), (qb, tb) = pose(0), pose(OPEN)
    turns = evaluate(command, "slerp", "ax ay az aw bx by bz bw t", [qa + qb + (t,) for t in parameters])
    return [(q, tuple((1 - t) * x + t * y for x, y in zip(ta, tb))) for q, t in zip(turns, parameters)]


def place(pose_of_door, x, y=0.0):
    """Where the point (x, y) of the door is in the picture."""
    (_, _, s, c), t = pose_of_door
    cos, sin = c * c - s * s, 2 * s * c
    return on_page(t[0] + cos * x - sin * y, t[1] + sin * x + cos * y)


def on_page(x, y):
    return (x - LEFT) * SCALE, (TOP - y) * SCALE


def number(x):
    return f"{x + 0.0:.2f}"


def points(corners):
    return " ".join(number(x) + "," + number(y) for x, y in corners)


def polyline(corners, style):
    return f'<polyline points="{points(corners)}" fill="none" {style}/>'


def door(pose_of_door, style):
    x, y = WIDTH / 2, THICK / 2
    corners = [place(pose_of_door, *c) for c in ((-x, -y), (x, -y), (x, y), (-x, y))]
    return f'<polygon points="{points(corners)}" {style}/>'


def text(at, words, color=INK, anchor="start"):
    return (f'<text x="{number(at[0])}" y="{number(at[1])}" fill="{color}" text-anchor="{anchor}">{words}</text>')


def dot(at, radius, color):
    return f'<circle cx="{number(at[0])}" cy="{number(at[1])}" r="{radius}" fill="{color}"/>'


def wall(first, last):
    (x, y), (right, _) = on_page(first, HINGE[1] + 0.04), on_page(last, HINGE[1])
    return f'<rect x="{number(x)}" y="{number(y)}" width="{number(right - x)}" height="{number(0.08 * SCALE)}" ' \
           f'fill="{WALL}"/>'


def picture(command):
    steps = [k / STEPS for k in range(STEPS + 1)]
    fine = [k / 60 for k in range(61)]
    doors, path = by_sclerp(command, steps), by_sclerp(command, fine)
    others, other_path = by_lerp_and_slerp(command, steps), by_lerp_and_slerp(command, fine)
    edge = WIDTH / 2
    dashed = f'stroke="{OTHER}" stroke-dasharray="7 5"'
    width, height = (RIGHT - LEFT) * SCALE, (TOP - BOTTOM) * SCALE
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{number(width)}" height="{number(height)}" '
        f'viewBox="0 0 {number(width)} {number(height)}" font-family="Helvetica, Arial, sans-serif" font-size="15">',
        "<title>A door that opens, seen from above</title>",
        f'<rect width="{number(width)}" height="{number(height)}" fill="#ffffff"/>',
        wall(LEFT + 0.1, HINGE[0] - 0.03),
        wall(HINGE[0] + WIDTH + 0.03, RIGHT - 0.1),
    ]
    for p in doors[1:-1]:
        lines.append(door(p, f'fill="{DOOR}" stroke="{PATH}" stroke-width="0.8"'))
    for p in (doors[0], doors[-1]):
        lines.append(door(p, f'fill="{PATH}" stroke="{PATH}"'))
    lines.append(polyline([place(p, edge) for p in path], f'stroke="{PATH}" stroke-width="2"'))
    for p in others[1:-1]:
        lines.append(polyline([place(p, -edge), place(p, edge)], dashed + ' stroke-width="1.2"'))
    for end in (-edge, edge):
        lines.append(polyline([place(p, end) for p in other_path], dashed + ' stroke-width="2.2"'))
        lines += [dot(place(p, end), 3.5, OTHER) for p in others[1:-1]]
    lines += [dot(place(p, edge), 3.5, PATH) for p in doors]
    for t, p in list(zip(steps, doors))[1:-1]:
        x, y = place(p, edge + 0.065)
        lines.append(text((x, y + 4), f"{t:g}", PATH, "middle"))
    lines.append(dot(on_page(*HINGE), 7, INK))
    lines.append(dot(on_page(*HINGE), 3, "#ffffff"))

    x, y = on_page(*HINGE)
    lines.append(text((x + 14, y + 30), "hinge"))
    x, y = place(doors[0], edge)
    lines.append(text((x - 8, y + 30), "closed, t = 0", anchor="end"))
    x, y = place(doors[-1], edge)
    lines.append(text((x - 12, y - 10), "open, t = 1", anchor="end"))
    x, y = place(others[2], -edge)
    lines.append(text((x - 10, y + 24), "the hinge wanders off by 20 cm", OTHER, "middle"))
    x, y = on_page(2.62, 1.86)
    for row, (words, style, color) in enumerate((("free edge, sclerp", f'stroke="{PATH}" stroke-width="2"', PATH),
                                                 ("lerp and slerp", dashed + ' stroke-width="2.2"', OTHER))):
        at = y + 24 * row
        lines.append(polyline([(x, at), (x + 44, at)], style))
        lines.append(text((x + 54, at + 5), words, color))
    return "\n".join(lines + ["</svg>"]) + "\n"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.stdout.write(picture(sys.argv[1:]))


if __name__ == "__main__":
    main()
