/**
 * Navigation: moves the viewer by the user's input.
 *
 * <p>In: motion requests ({@link org.selectiverenderer.runtime.navigation.MotionRequest}), which
 * {@link org.selectiverenderer.runtime.navigation.KeyboardMouseControls} makes from keys and mouse,
 * and collision geometry. Out: {@link org.selectiverenderer.runtime.navigation.NavigationMotion}, a
 * motion of the viewer that keeps to the ground, climbs steps and slides along walls. Uses {@code
 * runtime.collide}, {@code runtime.nodes.group}, {@code runtime.viewer} and {@code x3d.catalogue};
 * no windows, no GL.
 */
@NullMarked
package org.selectiverenderer.runtime.navigation;

import org.jspecify.annotations.NullMarked;
