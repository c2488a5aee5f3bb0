/**
 * The tree of the scene's elements: all of them, or only Switches and ProximitySensors; lazy, for
 * large scenes. While the text is not well formed it shows the last well-formed elements, greyed.
 *
 * <p>In: a session. Out: selections, and nodes that are dragged to other places. Uses {@code
 * enricher.component}, {@code enricher.session}, {@code enricher.text}, {@code authoring}, {@code
 * authoring.enrichment}, {@code authoring.structure}, {@code authoring.versions} for hints of
 * unnamed elements and {@code x3d.source}.
 */
@NullMarked
package org.selectiverenderer.enricher.tree;

import org.jspecify.annotations.NullMarked;
