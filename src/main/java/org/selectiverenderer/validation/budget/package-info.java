/**
 * Polygon budgets of a configuration, SR5xx, against the worst state that a viewer can reach. In:
 * {@code SceneView} with its settings. Uses {@code validation}, {@code polygon.statistics} and
 * {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.validation.budget;

import org.jspecify.annotations.NullMarked;
