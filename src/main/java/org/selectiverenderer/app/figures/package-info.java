/**
 * The figures of a run: times, polygons, memory.
 *
 * <p>In: each frame as it is drawn. Out: {@link org.selectiverenderer.app.figures.RunFigures}, and
 * their JSON. Uses {@code runtime.render} for what was drawn, {@code tracker} for the delay of its
 * records, and {@code base}.
 */
@NullMarked
package org.selectiverenderer.app.figures;

import org.jspecify.annotations.NullMarked;
