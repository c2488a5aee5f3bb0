/**
 * What an author does to a scene's text by hand, without a window: search and replace, comments,
 * elements cut, pasted and deleted, what may be typed at the caret, fields of any node.
 *
 * <p>In: a document, places in it, the node catalogue. Out: ranges, proposals, and {@link
 * org.selectiverenderer.document.Edit}s of one step each that change the bytes they name only.
 * Nothing here needs the text to be well formed unless it is handed an element: searching and
 * completing look at characters, so that they work while a tag is half typed. What takes time on
 * hostile input (patterns, tags without end) has a bound and says when it is reached.
 *
 * <p>Fields: {@link org.selectiverenderer.document.hand.NodeFields} lists what a node may be given
 * (types, defaults and ranges of the catalogue), each as it is written now; {@link
 * org.selectiverenderer.document.hand.FieldEdits} says what is wrong with a value and writes it. A
 * value that comes out of an entity of the DOCTYPE is shown and not written.
 *
 * <p>Uses {@code document}, {@code document.nodes}, {@code x3d.catalogue}, {@code x3d.field} and
 * {@code x3d.source}. For the thread that owns the document.
 */
@NullMarked
package org.selectiverenderer.document.hand;

import org.jspecify.annotations.NullMarked;
