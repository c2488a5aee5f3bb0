/**
 * The schema metadata of a document (thesis 4.2.2): reading the metadata of its Switches and
 * ProximitySensors, and edits that change it. There are no widgets; every action of the enricher's
 * forms, tables and menus is a method here.
 *
 * <p>{@link org.selectiverenderer.authoring.enrichment.DocumentEnrichment} reads; {@link
 * org.selectiverenderer.authoring.enrichment.EnrichmentEdits} makes edits; {@link
 * org.selectiverenderer.authoring.enrichment.QualityEdits} makes those of the qualities beside the
 * versions, for the fields that {@link org.selectiverenderer.authoring.enrichment.QualityTargets}
 * finds; {@link org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix} is the table of
 * objects by schemas; {@link org.selectiverenderer.authoring.enrichment.MetadataTable} reads
 * METADATA.csv; {@link org.selectiverenderer.authoring.enrichment.FieldQualityEdits} reads and
 * writes qualities that are values of fields.
 *
 * <p>In: a document, the wanted metadata. Out: edits, not yet performed; problems. Uses {@code
 * authoring}, {@code schema}, {@code x3d.catalogue}, {@code x3d.source}, {@code authoring.routes}
 * for the fields of nodes, {@code formats.csv} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.authoring.enrichment;

import org.jspecify.annotations.NullMarked;
