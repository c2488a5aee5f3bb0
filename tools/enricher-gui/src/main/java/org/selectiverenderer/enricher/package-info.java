/**
 * The enricher's window (thesis Fig 44): an author's view of a {@code document}. Widgets only; what
 * they do is done by package {@code document}, which has no window.
 *
 * <p>In: a scene's file, the author's hands. Out: edits of the document. Uses {@code document},
 * {@code schema}, {@code x3d}, {@code polygon}, {@code app} and {@code runtime} for the preview.
 */
@NullMarked
package org.selectiverenderer.enricher;

import org.jspecify.annotations.NullMarked;
