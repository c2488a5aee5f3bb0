/**
 * Placing the selected nodes in the window: moving, turning and scaling them, aligning and
 * distributing several, grouping and ungrouping, and the path of names that selects what is around.
 *
 * <p>{@code PlacementDrag} computes what a drag of a handle does, for preview and plan alike;
 * {@code PlacementCommands} are the commands, {@code PlacementEditor} what they and the form do to
 * the document; {@code HandleSettings} say what the handles do and whether the author measures;
 * {@code SelectionPath} shows the nodes around the selected one.
 *
 * <p>In: the selection, boxes from the running scene, the author's choice. Out: edits of the
 * document, selections. Uses {@code enricher.area}, {@code enricher.menu}, {@code
 * enricher.session}, {@code enricher.text}, {@code authoring.placement}, {@code authoring.area} and
 * {@code geometry}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.placement;

import org.jspecify.annotations.NullMarked;
