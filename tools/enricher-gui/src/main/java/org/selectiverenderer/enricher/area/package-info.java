/**
 * The commands for areas and Switches, which all views share: they ask for a name, make one edit
 * and select the result. The edits are those of {@code authoring.area}, {@code authoring.switches}
 * and {@code authoring.nodes}.
 *
 * <p>{@link org.selectiverenderer.enricher.area.AsyncSceneQueries} declares the queries of the
 * running scene (how large is a node, where are floor and ceiling, what is seen from above); the
 * preview implements it, so that this package does not depend on the preview. {@link
 * org.selectiverenderer.enricher.area.GridSetting} is the grid that every view snaps to.
 *
 * <p>Uses {@code enricher.menu}, {@code enricher.session}, {@code enricher.settings}, {@code
 * enricher.text}, {@code authoring}, {@code geometry} and {@code base.decimal}. For the event
 * dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.area;

import org.jspecify.annotations.NullMarked;
