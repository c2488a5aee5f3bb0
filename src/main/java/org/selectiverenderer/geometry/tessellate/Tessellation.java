package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * What became of a geometry node.
 *
 * @param mesh what is drawn
 * @param degenerateFaces triangles that the node gives but that have no area: left out of the mesh
 *     without a word, because exporters write them by the thousand and nobody can see them
 */
record Tessellation(Mesh mesh, int degenerateFaces) {}
