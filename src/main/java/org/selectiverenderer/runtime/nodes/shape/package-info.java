/**
 * Shapes that make their own mesh of a geometry: InstancedShape; and GeneratedCubeMapTexture, which
 * says when its pictures are drawn.
 *
 * <p>In: fields, and the meshes of geometry nodes. Out: one mesh, which is drawn, pointed at,
 * bumped into and counted like that of a Shape. Uses {@code runtime.scene}, {@code nodes.sensor},
 * {@code geometry.mesh} and {@code geometry.tessellate}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.shape;

import org.jspecify.annotations.NullMarked;
