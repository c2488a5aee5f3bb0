/**
 * Files to running scenes: the scene's file and all Inlines and images it names, read and
 * tessellated in parallel, all versions up front.
 *
 * <p>In: a path. Out: a {@link org.selectiverenderer.runtime.loading.LoadedScene} and problems.
 * Uses {@code x3d}, {@code runtime.scene}, {@code runtime.nodes} and the assets' interface of
 * {@code runtime.instance}. The network is never used.
 */
@NullMarked
package org.selectiverenderer.runtime.loading;

import org.jspecify.annotations.NullMarked;
