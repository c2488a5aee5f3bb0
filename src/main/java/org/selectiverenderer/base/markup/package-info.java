/**
 * Text as markup holds it: the one place that escapes what XML and HTML give a meaning of their
 * own. Values of X3D fields have rules of their own and are written elsewhere.
 *
 * <p>In and out: strings. Uses nothing else of ours.
 */
@NullMarked
package org.selectiverenderer.base.markup;

import org.jspecify.annotations.NullMarked;
