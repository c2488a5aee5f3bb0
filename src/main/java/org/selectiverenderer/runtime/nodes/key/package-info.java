/**
 * Key device sensors (X3D 4.0, clause 21): what the user types.
 *
 * <p>{@link org.selectiverenderer.runtime.nodes.key.KeyDevice} is the keyboard of a world. It gives
 * each {@link org.selectiverenderer.runtime.nodes.key.KeyStroke} to the one sensor that is active
 * and says which keys the scene wants for itself, so that the program's own keys work where it does
 * not.
 *
 * <p>In: key strokes, from any thread; the sensors of the scene. Out: events. Uses {@code
 * runtime.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.key;

import org.jspecify.annotations.NullMarked;
