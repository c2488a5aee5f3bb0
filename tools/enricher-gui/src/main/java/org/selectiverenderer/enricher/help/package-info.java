/**
 * The context-sensitive help: the terms in the author's words, for tooltips and the Help view.
 *
 * <p>In: a session. Out: texts, and a view that follows the focus. Uses {@code enricher.session},
 * {@code enricher.text}, {@code validation} and {@code x3d.source}.
 */
@NullMarked
package org.selectiverenderer.enricher.help;

import org.jspecify.annotations.NullMarked;
