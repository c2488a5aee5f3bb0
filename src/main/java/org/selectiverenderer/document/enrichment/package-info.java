/**
 * The schema metadata of a document (thesis 4.2.2): reading the metadata of its Switches and
 * ProximitySensors, and edits that change it. There are no widgets; every action of the enricher's
 * forms, tables and menus is a method here.
 *
 * <p>{@link org.selectiverenderer.document.enrichment.DocumentEnrichment} reads; {@link
 * org.selectiverenderer.document.enrichment.EnrichmentEdits} makes edits; {@link
 * org.selectiverenderer.document.enrichment.ObjectSchemaMatrix} is the table of objects by schemas;
 * {@link org.selectiverenderer.document.enrichment.MetadataTable} reads METADATA.csv.
 *
 * <p>In: a document, the wanted metadata. Out: edits, not yet performed; problems. Uses {@code
 * document}, {@code schema}, {@code x3d.catalogue}, {@code x3d.source}, {@code base.csv} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.document.enrichment;

import org.jspecify.annotations.NullMarked;
