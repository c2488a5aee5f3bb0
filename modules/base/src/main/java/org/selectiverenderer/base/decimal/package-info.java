/**
 * Formats numbers as decimal text, independent of the machine and the locale.
 *
 * <p>In: floats and doubles. Out: text. Uses nothing of the other packages.
 */
@NullMarked
package org.selectiverenderer.base.decimal;

import org.jspecify.annotations.NullMarked;
