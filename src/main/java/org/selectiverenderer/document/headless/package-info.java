/**
 * Enriching a scene without a window: the edits of the enricher, given by tables.
 *
 * <p>In: a scene, METADATA.csv, RATINGS.csv. Out: the enriched scene, or its difference to the
 * original. Uses {@code document}, {@code document.enrichment}, {@code document.file}, {@code
 * document.ratings}, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.document.headless;

import org.jspecify.annotations.NullMarked;
