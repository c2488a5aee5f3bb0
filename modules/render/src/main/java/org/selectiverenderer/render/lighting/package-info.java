/**
 * Decides between per-vertex and per-pixel lighting of a shape: per vertex where interpolation is
 * hardly told from per-pixel lighting. Meshes that are too coarse for that are refined. Dull
 * highlights alone are no reason for refinement; they may be lost between the vertices of a large
 * face.
 *
 * <p>In: meshes, the lights of a scene, surfaces. Out: {@link
 * org.selectiverenderer.render.lighting.ShapeLighting}s and finer {@link
 * org.selectiverenderer.geometry.mesh.Mesh}es, without GL, on any thread. Refinement does not show
 * in statistics: the polygons that are counted remain the model's. Uses {@code browser.instance},
 * {@code geometry.mesh} and {@code geometry.bvh}.
 */
@NullMarked
package org.selectiverenderer.render.lighting;

import org.jspecify.annotations.NullMarked;
