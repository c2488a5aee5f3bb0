/**
 * The scene from above, in which areas are drawn: a tab beside the preview. What is under a height
 * is a picture, walls are lines where the cut goes through them, areas are rectangles with names.
 *
 * <p>{@link org.selectiverenderer.enricher.plan.PlanPanel} asks the running scene for a picture
 * when it is shown and the document has changed; areas are read from the document, so that they are
 * always those of the text. {@code PlanScale} is the way from the scene's X and Z to the screen,
 * {@code PlanSnap} what a coordinate keeps to, {@code PlanHands} the mouse, {@code PlanView} what
 * is painted.
 *
 * <p>In: the document's areas, a picture of the scene, the author's mouse and keys. Out: edits by
 * {@code enricher.area}. Uses {@code enricher.parts}, {@code enricher.area}, {@code
 * enricher.session}, {@code enricher.text}, {@code document.area}, {@code geometry} and {@code
 * base.decimal}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.plan;

import org.jspecify.annotations.NullMarked;
