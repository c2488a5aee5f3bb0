/**
 * Swing components and layouts that several views share: {@code WrapLayout} wraps components into
 * as many lines as the width needs, {@code AccessibleCanvas} is a custom-painted component that is
 * accessible as a canvas, {@code TextChangeListener} listens to every change of a text, {@code
 * NamedFileChooser} accepts only what can be the name of a file, {@code CollapsibleSplit} has a
 * lower view that can be folded away, {@code InputDialog} asks for input and gets every key typed
 * since it was asked for.
 *
 * <p>Uses {@code text} and the module {@code swing}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.component;

import org.jspecify.annotations.NullMarked;
