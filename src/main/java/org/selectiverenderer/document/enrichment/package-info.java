/**
 * The vocabulary of the thesis in a document (4.2.2): what its Switches and ProximitySensors say,
 * and edits that make them say something else. No widgets; every action of the enricher's forms,
 * tables and menus is a method here.
 *
 * <p>{@link org.selectiverenderer.document.enrichment.Enrichment} reads; {@link
 * org.selectiverenderer.document.enrichment.EnrichmentEdits} makes edits; {@link
 * org.selectiverenderer.document.enrichment.SchemaOverview} is the table of objects by schemas;
 * {@link org.selectiverenderer.document.enrichment.MetadataTable} reads METADATA.csv.
 *
 * <p>In: a document, what the author wants. Out: edits, not yet made; problems. Uses {@code
 * document}, {@code schema}, {@code x3d.catalogue}, {@code x3d.source}, {@code base.csv} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.document.enrichment;

import org.jspecify.annotations.NullMarked;
