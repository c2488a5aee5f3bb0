/**
 * Where the light of a shape is computed: at its vertices, where their interpolation is hardly told
 * from light by pixel, else at the pixels. Meshes that are too coarse for that are refined; dull
 * highlights alone are no reason, and fall between the vertices of a large face.
 *
 * <p>In: meshes, the lights of a scene, surfaces. Out: {@link
 * org.selectiverenderer.runtime.render.light.Lighting}s and finer {@link
 * org.selectiverenderer.geometry.mesh.Mesh}es, without GL, on any thread. Refinement shows in no
 * figure: polygons that are counted remain the model's. Uses {@code runtime.instance}, {@code
 * geometry.mesh} and {@code geometry.tree}.
 */
@NullMarked
package org.selectiverenderer.runtime.render.light;

import org.jspecify.annotations.NullMarked;
