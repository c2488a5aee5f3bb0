/**
 * Loads files into running scenes: reads the scene's file and all Inlines and images that it names
 * and tessellates their geometry, in parallel and with all versions up front. {@code x3d.files}
 * decides which files may be read.
 *
 * <p>Files that a running scene names later are read in the background; {@link
 * org.selectiverenderer.runtime.loading.FrameBudgetQueue} puts them into the scene, a limited
 * amount per frame.
 *
 * <p>In: a path. Out: a {@link org.selectiverenderer.runtime.loading.LoadedScene} and problems.
 * Uses {@code runtime.scene}, {@code runtime.nodes}, the asset interface of {@code
 * runtime.instance}, {@code runtime.sound}, {@code runtime.movie}, {@code geometry}, {@code x3d}
 * and {@code base.problem}; ImageIO decodes the images that this package's own decoders do not.
 */
@NullMarked
package org.selectiverenderer.runtime.loading;

import org.jspecify.annotations.NullMarked;
