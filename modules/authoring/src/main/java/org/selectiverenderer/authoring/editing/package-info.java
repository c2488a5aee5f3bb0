/**
 * Editing of a scene's text, without a window: search and replace, commenting out, code completion,
 * fields of any node.
 *
 * <p>In: a document, positions in it, the node catalogue. Out: ranges, proposals, and {@link
 * org.selectiverenderer.authoring.Edit}s, each one undo step that changes only the bytes it names.
 * Only methods that take an element need a well-formed text: searching and completion read
 * characters, so that they work while a tag is incomplete. Work that may take long on hostile input
 * (patterns, endless tags) is bounded and reports when the bound is reached.
 *
 * <p>Fields: {@link org.selectiverenderer.authoring.editing.NodeFieldList} lists the fields of a
 * node (types, defaults and ranges of the catalogue) with their written values; {@link
 * org.selectiverenderer.authoring.editing.FieldEdits} validates and writes a value. Behind them are
 * the fields that the prototype of an instance declares in the instance's scope; their values are
 * fieldValues. The file of an EXTERNPROTO is not read, so that its defaults are unknown. A value
 * that comes from an entity of the DOCTYPE is shown but not written.
 *
 * <p>Uses {@code authoring}, {@code authoring.nodes}, {@code x3d.catalogue}, {@code x3d.field} and
 * {@code x3d.source}. For the thread that owns the document.
 */
@NullMarked
package org.selectiverenderer.authoring.editing;

import org.jspecify.annotations.NullMarked;
