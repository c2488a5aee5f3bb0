/**
 * The vocabulary in the author's words, for tooltips and the help view beside what has the focus.
 *
 * <p>In: a session. Out: texts, and a view that follows the focus. Uses {@code enricher.session},
 * {@code enricher.text}, {@code validation} and {@code x3d.source}.
 */
@NullMarked
package org.selectiverenderer.enricher.help;

import org.jspecify.annotations.NullMarked;
