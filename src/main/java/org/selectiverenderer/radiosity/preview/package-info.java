/**
 * Small pictures of light while it is computed: rays through pixels, PNG without AWT.
 *
 * <p>In: a scene and its light so far. Out: the bytes of a PNG file. Uses {@code radiosity.bake},
 * {@code .scene}, {@code .solve} and {@code .trace}.
 */
@NullMarked
package org.selectiverenderer.radiosity.preview;

import org.jspecify.annotations.NullMarked;
