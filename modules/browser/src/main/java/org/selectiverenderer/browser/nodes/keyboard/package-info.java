/**
 * Key device sensors (X3D 4.0, clause 21).
 *
 * <p>{@link org.selectiverenderer.browser.nodes.keyboard.KeyDevice} is the keyboard of a world. It
 * gives each {@link org.selectiverenderer.browser.nodes.keyboard.KeyboardEvent} to the active
 * sensor and tells which keys the scene consumes, so that the program's own shortcuts work for all
 * others.
 *
 * <p>In: key events, from any thread; the sensors of the scene. Out: events. Uses {@code
 * browser.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.keyboard;

import org.jspecify.annotations.NullMarked;
