/**
 * What several views are made of: {@code WrappingLines} puts parts in lines as wide as there is
 * room for, {@code PaintedComponent} is what paints itself and tells a screen reader so.
 *
 * <p>In: components, their room. Out: their places. Uses nothing of ours. For the event dispatch
 * thread.
 */
@NullMarked
package org.selectiverenderer.enricher.parts;

import org.jspecify.annotations.NullMarked;
