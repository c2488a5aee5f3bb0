/**
 * The vocabulary in the author's words, for tooltips and the help view.
 *
 * <p>In: a session. Out: texts, and a view that follows the focus.
 */
@NullMarked
package org.selectiverenderer.enricher.help;

import org.jspecify.annotations.NullMarked;
