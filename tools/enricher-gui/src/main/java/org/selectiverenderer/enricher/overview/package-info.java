/**
 * The table of objects by schemas, for enriching many objects at once: a table model that knows no
 * window, and the panel around it.
 *
 * <p>In: an enrichment. Out: edits. Uses {@code enricher.component}, {@code enricher.session},
 * {@code authoring}, {@code authoring.enrichment}, {@code schema} and {@code x3d.source}.
 */
@NullMarked
package org.selectiverenderer.enricher.overview;

import org.jspecify.annotations.NullMarked;
