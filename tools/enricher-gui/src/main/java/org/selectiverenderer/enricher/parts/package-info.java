/**
 * Swing components and layouts that several views share: {@code WrappingLines} wraps components
 * into as many lines as the width needs, {@code PaintedComponent} is a custom-painted component
 * that is accessible as a canvas.
 *
 * <p>Uses nothing of ours. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.parts;

import org.jspecify.annotations.NullMarked;
