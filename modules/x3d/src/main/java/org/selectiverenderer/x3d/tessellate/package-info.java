/**
 * Tessellates X3D geometry nodes into meshes of triangles, lines or points.
 *
 * <p>In: a geometry node of a file or of a running scene. Out: a {@link
 * org.selectiverenderer.geometry.mesh.Mesh}. Uses {@code geometry}, {@code geometry.mesh}, {@code
 * geometry.font} for texts, {@code x3d.geodesy}, {@code geometry.nurbs}, {@code x3d.catalogue},
 * {@code base.problem} and earcut4j, which triangulates polygons; no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.x3d.tessellate;

import org.jspecify.annotations.NullMarked;
