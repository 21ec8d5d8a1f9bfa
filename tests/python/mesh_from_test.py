"""Meshes of meshio, to and fro."""
import meshio
import numpy as np
import pytest

import ringwatch as rw
from support import bar, body_of

ELEMENTS = {"tet4": "tetra", "tet10": "tetra10", "hex8": "hexahedron", "hex20": "hexahedron20", "wedge6": "wedge",
            "pyramid5": "pyramid"}


@pytest.mark.parametrize("element", ELEMENTS)
def test_a_mesh_read_by_meshio_is_ours(tmp_path, element):
    mesh = bar(element=element, jitter=0)
    mesh.save(tmp_path / "bar.msh")
    theirs = meshio.read(tmp_path / "bar.msh")
    assert ELEMENTS[element] in {block.type for block in theirs.cells}
    ours = rw.mesh_from(theirs)
    assert np.array_equal(ours.points, mesh.points)
    for (name, cells), (again, same) in zip(mesh.blocks, ours.blocks):
        assert name == again and np.array_equal(cells, same)


def test_steps_go_back_into_the_mesh(tmp_path):
    points = bar(cells=[3, 1, 1]).points
    mesh = bar(cells=[3, 1, 1])
    triangles = np.array([[0, 1, 2]])
    theirs = meshio.Mesh(points, [("triangle", triangles), ("tetra", mesh.cells["tet4"])])
    ours = rw.mesh_from(theirs)
    steps = rw.inspect(body_of(ours), metrics=["single-element"]).element_steps
    volume = meshio.Mesh(ours.points, [("tetra", ours.cells["tet4"])], cell_data={"step": list(steps)})
    volume.write(tmp_path / "steps.vtu")
    assert np.array_equal(meshio.read(tmp_path / "steps.vtu").cell_data["step"][0], steps[0])
