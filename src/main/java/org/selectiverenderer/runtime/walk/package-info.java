/**
 * Walking: how a user's intentions move the viewer.
 *
 * <p>In: input as intentions ({@link org.selectiverenderer.runtime.walk.Motion}), which {@link
 * org.selectiverenderer.runtime.walk.Controls} makes of keys and mouse, and what is solid. Out:
 * {@link org.selectiverenderer.runtime.walk.Walker}, a motion of the viewer that keeps to the
 * ground, climbs steps and slides along walls. Uses {@code runtime.collide}, {@code
 * runtime.nodes.group}, {@code runtime.viewer} and {@code x3d.catalogue}; no windows, no GL.
 */
@NullMarked
package org.selectiverenderer.runtime.walk;

import org.jspecify.annotations.NullMarked;
