/**
 * Loads files into running scenes: reads the scene's file and all Inlines and images that it names
 * and tessellates their geometry, in parallel and with all versions up front. {@code x3d.url}
 * decides which files may be read.
 *
 * <p>Files that a running scene names later are read in the background; {@link
 * org.selectiverenderer.browser.loading.FrameBudgetQueue} puts them into the scene, a limited
 * amount per frame.
 *
 * <p>In: a path. Out: a {@link org.selectiverenderer.browser.loading.LoadedScene} and problems.
 * Uses {@code browser.scene}, {@code browser.nodes}, the asset interface of {@code
 * browser.instance}, {@code browser.sound}, {@code browser.movie}, {@code geometry}, {@code x3d}
 * and {@code base.problem}; ImageIO decodes the images that this package's own decoders do not.
 */
@NullMarked
package org.selectiverenderer.browser.loading;

import org.jspecify.annotations.NullMarked;
