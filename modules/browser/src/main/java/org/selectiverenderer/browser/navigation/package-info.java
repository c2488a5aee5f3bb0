/**
 * Navigation: moves the viewer by the user's input.
 *
 * <p>In: motion requests ({@link org.selectiverenderer.browser.navigation.MotionRequest}), which
 * {@link org.selectiverenderer.browser.navigation.KeyboardMouseControls} makes from keys and mouse,
 * and collision geometry. Out: {@link org.selectiverenderer.browser.navigation.NavigationMotion}, a
 * motion of the viewer that keeps to the ground, climbs steps and slides along walls. Uses {@code
 * browser.collision}, {@code browser.nodes.group}, {@code browser.viewer} and {@code
 * x3d.catalogue}; no windows, no GL.
 */
@NullMarked
package org.selectiverenderer.browser.navigation;

import org.jspecify.annotations.NullMarked;
