/**
 * The vocabulary in the author's words, for tooltips and the help view.
 *
 * <p>In: nothing. Out: texts and a view.
 */
@NullMarked
package org.selectiverenderer.enricher.help;

import org.jspecify.annotations.NullMarked;
