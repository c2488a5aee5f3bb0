/**
 * Files to running scenes: the scene's file and all Inlines and images it names, read and
 * tessellated in parallel, all versions up front. Which files may be read, {@code x3d.files}
 * decides.
 *
 * <p>What a running scene comes to name is read in the background; {@link
 * org.selectiverenderer.runtime.loading.Arrivals} lets it in, so much with each frame.
 *
 * <p>In: a path. Out: a {@link org.selectiverenderer.runtime.loading.LoadedScene} and problems.
 * Uses {@code runtime.scene}, {@code runtime.nodes}, the assets' interface of {@code
 * runtime.instance}, {@code runtime.sound}, {@code runtime.movie}, {@code geometry}, {@code x3d}
 * and {@code base.problem}; AWT's ImageIO reads the images but those of {@code PngImage}.
 */
@NullMarked
package org.selectiverenderer.runtime.loading;

import org.jspecify.annotations.NullMarked;
