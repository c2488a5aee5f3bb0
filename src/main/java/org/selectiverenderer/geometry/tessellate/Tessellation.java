package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The result of tessellating a geometry node.
 *
 * @param mesh the mesh
 * @param degenerateFaces the number of triangles without area that were left out; they are not
 *     reported as problems, because exporters write thousands of them and they are invisible
 */
record Tessellation(Mesh mesh, int degenerateFaces) {}
