/**
 * What a run is to be, in parts: the scene, what moves the viewer, the display, the head and its
 * log.
 *
 * <p>In: what the command line or a study says. Out: values; nothing here does anything. May use
 * {@code control}, {@code hmd}, {@code tracker}, {@code runtime} and {@code x3d.files} for their
 * own settings.
 */
@NullMarked
package org.selectiverenderer.app.settings;

import org.jspecify.annotations.NullMarked;
