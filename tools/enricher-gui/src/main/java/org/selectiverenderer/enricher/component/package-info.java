/**
 * Swing components and layouts that several views share: {@code WrapLayout} wraps components into
 * as many lines as the width needs, {@code AccessibleCanvas} is a custom-painted component that is
 * accessible as a canvas, {@code TextChangeListener} listens to every change of a text, {@code
 * NamedFileChooser} accepts only what can be the name of a file, {@code CollapsibleSplit} has a
 * lower view that can be folded away.
 *
 * <p>Uses {@code text}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.component;

import org.jspecify.annotations.NullMarked;
