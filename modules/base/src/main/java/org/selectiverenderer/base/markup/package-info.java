/**
 * Escapes the special characters of XML and HTML, and makes control characters visible. X3D field
 * values have further quoting rules and are written elsewhere.
 *
 * <p>In and out: strings. Uses nothing else of ours.
 */
@NullMarked
package org.selectiverenderer.base.markup;

import org.jspecify.annotations.NullMarked;
