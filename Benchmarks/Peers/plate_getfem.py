#!/usr/bin/python3
"""The patched plate by GetFEM: C1 composite quadrangles, SuperLU and ARPACK of SciPy at shift zero.

plate_getfem.py DIVISIONS LAYERS COUNT
DIVISIONS elements in 5 mm, the grid in which the ceramics lie; LAYERS further lines beside clamp, sides and ceramics.
"""
import sys
import time

import getfem
import numpy
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import LinearOperator, eigsh, splu

UNIT, RATIO = 0.005, 0.3
HS, E, NU, RHO = 1e-3, 70e9, 0.33, 2700
HP, EP, NUP, RHOP = 0.5e-3, 62.5e9, 0.31, 7800
CERAMICS, CLAMP = 1, 2


def grid(lines, cells, divisions, layers):
    steps = RATIO ** numpy.arange(1, layers + 1) / divisions
    near = numpy.add.outer(lines, numpy.concatenate([-steps, steps])).ravel()
    return UNIT * numpy.union1d(numpy.arange(cells * divisions + 1) / divisions, near[(near > 0) & (near < cells)])


def plate_mesh(divisions, layers):
    xs = grid([0, 2, 7, 12, 17, 22, 27, 32, 37], 40, divisions, layers)
    ys = grid([0, 3, 8, 16, 21, 24], 24, divisions, layers)
    mesh = getfem.Mesh("cartesian", xs, ys)
    points, cells = mesh.pid_from_cvid()
    corners = mesh.pts()[:, points].reshape(2, len(cells) - 1, 4)
    x, y = corners.mean(axis=2) / UNIT
    # Four columns of ceramics every 50 mm from 10 mm, two rows from 15 and 80 mm, each 25 mm long.
    on_ceramic = (x > 2) & ((x - 2) % 10 < 5) & (((y > 3) & (y < 8)) | ((y > 16) & (y < 21)))
    ids = mesh.cvid()[on_ceramic]
    mesh.set_region(CERAMICS, numpy.vstack([ids, numpy.full_like(ids, -1)]))
    mesh.set_region(CLAMP, mesh.outer_faces_with_direction([-1.0, 0.0], 0.01))
    return mesh


def assembled(fem, degree, form, region):
    rule = getfem.MeshIm(fem.linked_mesh(), getfem.Integ(f"IM_QUADC1_COMPOSITE(IM_TRIANGLE({degree}))"))
    matrix = getfem.asm_generic(rule, 2, form, region, "w", 1, fem, numpy.zeros(fem.nbdof()))
    columns, rows = matrix.csc_ind()
    return csc_matrix((matrix.csc_val(), rows, columns), shape=matrix.size())


def matrices(mesh):
    fem = getfem.MeshFem(mesh, 1)
    fem.set_fem(getfem.Fem("FEM_QUADC1_COMPOSITE"))
    distance = (HS + HP) / 2
    plate = E / (1 - NU**2) * HS**3 / 12
    added = EP / (1 - NUP**2) * (HP**3 / 6 + 2 * distance**2 * HP)
    stiffness = mass = 0
    for region, rigidity, nu, density in ((-1, plate, NU, RHO * HS), (CERAMICS, added, NUP, 2 * RHOP * HP)):
        # D11 = D22 = D12 + 2 D66 in an isotropic layer.
        bending = f"{rigidity * (1 - nu)!r}*(Hess_w:Hess_Test_w) + {rigidity * nu!r}*Trace(Hess_w)*Trace(Hess_Test_w)"
        stiffness = stiffness + assembled(fem, 2, bending, region)
        mass = mass + assembled(fem, 6, f"{density!r}*w*Test_w", region)
    free = numpy.setdiff1d(numpy.arange(fem.nbdof()), fem.basic_dof_on_region(CLAMP))
    return stiffness[free][:, free].tocsc(), mass[free][:, free].tocsc()


def main():
    divisions, layers, count = map(int, sys.argv[1:])
    getfem.util("warning level", 0)
    start = time.process_time()
    stiffness, mass = matrices(plate_mesh(divisions, layers))
    # Both are symmetric and definite: no pivots, and an ordering for symmetric matrices, much faster than SciPy's default.
    factor = splu(stiffness, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    inverse = LinearOperator(stiffness.shape, matvec=factor.solve, dtype=float)
    begin = numpy.random.default_rng(1).standard_normal(stiffness.shape[0])
    squares = eigsh(stiffness, k=count, M=mass, sigma=0.0, OPinv=inverse, tol=1e-6, v0=begin, return_eigenvectors=False)
    seconds = time.process_time() - start
    print("unknowns", stiffness.shape[0])
    print("seconds", seconds)
    for square in numpy.sort(squares):
        print("frequency", numpy.sqrt(square) / (2 * numpy.pi))


main()
