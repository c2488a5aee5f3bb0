/**
 * InstancedShape, which makes its own mesh of a geometry, and GeneratedCubeMapTexture, which tells
 * when its cube map is drawn.
 *
 * <p>In: fields, and the meshes of geometry nodes. Out: one mesh, which is used in drawing,
 * picking, collisions and polygon counts like that of a Shape. Uses {@code browser.scene}, {@code
 * nodes.sensor}, {@code geometry.mesh} and {@code x3d.tessellate}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.shape;

import org.jspecify.annotations.NullMarked;
