/**
 * The table of objects by schemas, for enriching many objects at once: a table model that knows no
 * window, and the panel around it.
 *
 * <p>In: an enrichment. Out: edits. Uses {@code enricher.parts}, {@code enricher.session}, {@code
 * document}, {@code document.enrichment}, {@code schema} and {@code x3d.source}.
 */
@NullMarked
package org.selectiverenderer.enricher.overview;

import org.jspecify.annotations.NullMarked;
