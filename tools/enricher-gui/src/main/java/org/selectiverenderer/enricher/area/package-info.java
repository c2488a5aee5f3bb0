/**
 * What an author does with areas and Switches, whichever view it is done in: commands that ask for
 * a name, make one edit and select what came of it. The edits are those of {@code document.area},
 * {@code document.switches} and {@code document.nodes}.
 *
 * <p>{@link org.selectiverenderer.enricher.area.SceneProbe} is what a command asks of the running
 * scene (how large is this, where are floor and ceiling, what is seen from above); the preview
 * answers, later and on the event dispatch thread, so that this package does not know it. {@link
 * org.selectiverenderer.enricher.area.GridSetting} is the grid that every view snaps to.
 *
 * <p>Uses {@code enricher.menu}, {@code enricher.session}, {@code enricher.settings}, {@code
 * enricher.text}, {@code document}, {@code geometry} and {@code base.decimal}. For the event
 * dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.area;

import org.jspecify.annotations.NullMarked;
