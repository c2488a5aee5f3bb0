/**
 * Rules of budgets of polygons, textures and draw calls, SR5xx: the budgets of the settings are
 * compared with the worst state that a viewer can reach.
 *
 * <p>In: {@code SceneContext} with its settings. Out: findings. Uses {@code validation}, {@code
 * polygon}, {@code schema}, {@code x3d.read} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.validation.budget;

import org.jspecify.annotations.NullMarked;
