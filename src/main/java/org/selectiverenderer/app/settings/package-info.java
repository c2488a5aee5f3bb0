/**
 * The settings of a run: the scene, the viewer's motion, the display, the tracker and the head log.
 *
 * <p>In: the options of the command line or of a study. Out: immutable values without behaviour.
 * May use {@code control}, {@code hmd}, {@code tracker}, {@code browser} and {@code x3d.url} for
 * their own settings.
 */
@NullMarked
package org.selectiverenderer.app.settings;

import org.jspecify.annotations.NullMarked;
