"""The plate aluminium-200x120 in solid elements: 20-node bricks with reduced integration (C3D20R), one layer for the plate and one for each ceramic, as a
file of CalculiX with its modes, and for each ceramic a static case at 1 V, free and with all nodes held. Strain by voltage is that of heat."""
import json

CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
MIDDLES = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]
PLATE = {"E": 70e9, "nu": 0.33, "density": 2700.0}
CERAMIC = {"E": 62.5e9, "nu": 0.31, "density": 7800.0, "d31": -195e-12, "d33": 443e-12}


def places(breaks, size):
    """Corners and middles of elements between breaks, mm, at most size long."""
    found = [breaks[0]]
    for low, high in zip(breaks, breaks[1:]):
        count = max(1, round((high - low) / size))
        found += [low + (high - low) * i / (2 * count) for i in range(1, 2 * count + 1)]
    return found


class Mesh:
    def __init__(self, device, size):
        x, y = sorted({0, device["length_x_mm"]} | ends(device, "x")), sorted({0, device["length_y_mm"]} | ends(device, "y"))
        half, thick = device["thickness_mm"] / 2, device["ceramics"][0]["thickness_mm"]
        self.x, self.y = places(x, size), places(y, size)
        self.z = [-half - thick, -half - thick / 2, -half, 0, half, half + thick / 2, half + thick]
        self.nodes, self.elements = {}, {"PLATE": []}
        self.add("PLATE", 0, device["length_x_mm"], 0, device["length_y_mm"], 2)
        self.faces = []
        for number, ceramic in enumerate(device["ceramics"], 1):
            box = [ceramic["x_mm"], ceramic["x_mm"] + ceramic["size_x_mm"], ceramic["y_mm"], ceramic["y_mm"] + ceramic["size_y_mm"]]
            self.faces.append([self.add(f"CERAMIC{number}", *box, layer) for layer in (0, 4)])

    def node(self, place):
        return self.nodes.setdefault(place, len(self.nodes) + 1)

    def add(self, name, x0, x1, y0, y1, layer):
        """Elements within a box; their nodes."""
        used = set()
        for i in range(0, len(self.x) - 1, 2):
            for j in range(0, len(self.y) - 1, 2):
                if x0 - 1e-9 < self.x[i] < x1 - 1e-9 and y0 - 1e-9 < self.y[j] < y1 - 1e-9:
                    nodes = [self.node((i + a, j + b, layer + c)) for a, b, c in CORNERS + MIDDLES]
                    self.elements.setdefault(name, []).append(nodes)
                    used |= set(nodes)
        return used

    def place(self, node):
        i, j, k = node
        return self.x[i] / 1000, self.y[j] / 1000, self.z[k] / 1000


def ends(device, axis):
    return {value for ceramic in device["ceramics"] for value in (ceramic[f"{axis}_mm"], ceramic[f"{axis}_mm"] + ceramic[f"size_{axis}_mm"])}


def listed(numbers):
    numbers = sorted(numbers)
    return "\n".join(", ".join(map(str, numbers[i:i + 12])) + "," for i in range(0, len(numbers), 12))


def materials(mesh, thickness):
    text = material("ALUMINIUM", PLATE) + "*SOLID SECTION, ELSET=PLATE, MATERIAL=ALUMINIUM\n"
    for name in list(mesh.elements)[1:]:
        strains = [CERAMIC["d31"] / thickness] * 2 + [CERAMIC["d33"] / thickness]
        text += material(f"M{name}", CERAMIC) + "*EXPANSION, TYPE=ORTHO\n" + ", ".join(f"{strain:.9e}" for strain in strains) + "\n"
        text += f"*SOLID SECTION, ELSET={name}, MATERIAL=M{name}\n"
    return text


def material(name, values):
    return f"*MATERIAL, NAME={name}\n*ELASTIC\n{values['E']:.6e}, {values['nu']}\n*DENSITY\n{values['density']}\n"


def case(number, output, held=""):
    """A ceramic at 1 V: that below strains as d31 says, that on top against it, so that the surface bulges outward. Docs/Theory.md, section 1.4."""
    return (f"*STEP\n*STATIC\n{held}*TEMPERATURE, OP=NEW\nNALL, 0.\nBELOW{number}, 1.\nABOVE{number}, -1.\n"
            f"*NODE FILE\n{output}\n*END STEP\n")


def written(device, size, modes, statics):
    """The text of CalculiX's input, and how many nodes it has.
    statics: whether the cases are also solved with the plate held at its clamp only"""
    mesh = Mesh(device, size)
    text = "*NODE, NSET=NALL\n" + "".join("{}, {:.9g}, {:.9g}, {:.9g}\n".format(number, *mesh.place(node)) for node, number in mesh.nodes.items())
    number = 0
    for name, elements in mesh.elements.items():
        text += f"*ELEMENT, TYPE=C3D20R, ELSET={name}\n"
        for nodes in elements:
            number += 1
            text += f"{number}, " + ", ".join(map(str, nodes[:15])) + ",\n" + ", ".join(map(str, nodes[15:])) + "\n"
    text += "*NSET, NSET=CLAMP\n" + listed(number for (i, _, k), number in mesh.nodes.items() if i == 0 and 2 <= k <= 4) + "\n"
    for index, faces in enumerate(mesh.faces, 1):
        for where, nodes in zip(("BELOW", "ABOVE"), faces):
            text += f"*NSET, NSET={where}{index}\n{listed(nodes)}\n"
    count = len(mesh.faces)
    text += materials(mesh, device["ceramics"][0]["thickness_mm"] / 1000)
    text += "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNALL, 0.\n*BOUNDARY\nCLAMP, 1, 3, 0.\n"
    text += f"*STEP\n*FREQUENCY\n{modes}\n*NODE FILE\nU\n*END STEP\n"
    if statics:
        text += "".join(case(index, "U") for index in range(1, count + 1))
    text += "".join(case(index, "RF", "*BOUNDARY\nNALL, 1, 3, 0.\n" if index == 1 else "") for index in range(1, count + 1))
    return text, len(mesh.nodes)


def deviceOf(path):
    return json.loads(open(path).read())
