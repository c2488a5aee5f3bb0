/**
 * Enriching a scene without a window: the edits of the enricher, given by tables.
 *
 * <p>In: a scene, METADATA.csv, RATINGS.csv, proposals from head logs. Out: the enriched scene, or
 * its difference to the original. Uses {@code authoring}, {@code authoring.enrichment}, {@code
 * authoring.file}, {@code authoring.ratings}, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.authoring.headless;

import org.jspecify.annotations.NullMarked;
