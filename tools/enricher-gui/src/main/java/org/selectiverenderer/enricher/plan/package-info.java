/**
 * The floor plan, in which areas are drawn: a tab beside the preview. Surfaces below a cutting
 * height are an image, walls are the lines in which the cut meets surfaces, areas are rectangles
 * with names.
 *
 * <p>{@link org.selectiverenderer.enricher.plan.PlanPanel} requests an image of the running scene
 * when it is shown and the document has changed; areas are read from the document, so that they
 * always match the text. {@code PlanTransform} transforms between world X and Z and the screen,
 * {@code PlanMouseController.WallSnapper} snaps edges to walls, {@code PlanMouseController} handles
 * the mouse, {@code FloorPlanCanvas} paints.
 *
 * <p>{@code PlanObjects} selects objects by clicks and by a rectangle, has the handles that move,
 * turn and scale them, hides them in the plan, and measures; {@code PlanObjectPainter} and {@code
 * ScaleBar} paint over the plan.
 *
 * <p>In: the document's areas, a picture of the scene, the author's mouse and keys. Out: edits by
 * {@code enricher.area}. Uses {@code enricher.component}, {@code enricher.area}, {@code
 * enricher.placement}, {@code enricher.session}, {@code enricher.text}, {@code authoring.area},
 * {@code geometry} and {@code base.decimal}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.plan;

import org.jspecify.annotations.NullMarked;
