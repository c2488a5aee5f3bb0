/**
 * Swing components and layouts that several views share: {@code WrapLayout} wraps components into
 * as many lines as the width needs, {@code AccessibleCanvas} is a custom-painted component that is
 * accessible as a canvas, {@code TextChangeListener} listens to every change of a text, {@code
 * NamedFileChooser} accepts only what can be the name of a file, {@code CollapsibleSplit} has a
 * lower view that can be folded away, {@code InitialFocus} shows a dialog whose first field gets
 * every key typed since it was asked for, {@code InputDialog} is such a dialog with OK and Cancel,
 * {@code FileNameSelection} selects the name in a field with a path.
 *
 * <p>Uses {@code text} and the module {@code swing}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.component;

import org.jspecify.annotations.NullMarked;
