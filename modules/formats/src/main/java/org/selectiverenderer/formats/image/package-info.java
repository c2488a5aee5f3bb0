/**
 * Writes picture files: SVG element by element ({@link
 * org.selectiverenderer.formats.image.SvgWriter}) and pixels as PNG ({@link
 * org.selectiverenderer.formats.image.PngEncoder}). {@link
 * org.selectiverenderer.formats.image.PictureSize} reads how large a picture is.
 *
 * <p>In: shapes or pixels from the upper left corner, y down. Out: text or bytes, reproducible:
 * every line of SVG ends with LF and every number has a decimal point, whatever the platform and
 * the locale. Uses {@code base.markup}; no AWT.
 */
@NullMarked
package org.selectiverenderer.formats.image;

import org.jspecify.annotations.NullMarked;
