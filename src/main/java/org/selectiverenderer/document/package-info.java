/**
 * A scene's file as its author's text, open for editing: lossless, every edit a named step that can
 * be undone, the elements and their places known after each.
 *
 * <p>The text is the truth. An edit is a few replacements of characters; the tree of elements
 * follows by reading again only what the replacements touch, so that an edit of a 30 MB scene takes
 * a few milliseconds. Elements that were not touched stay the same objects. A text that is not well
 * formed has no tree and a fault with its place; nothing is guessed.
 *
 * <p>A document belongs to one thread at a time. Snapshots of it are values.
 *
 * <p>Within: {@code enrichment} (the vocabulary of the thesis in a document), {@code ratings}
 * (expectancy ratings to metadata), {@code versions} (the polygon count process as an edit), {@code
 * file} (saving, recovery, differences).
 *
 * <p>In: bytes of a file, edits. Out: text, elements, bytes. Uses {@code x3d}; the packages within
 * also {@code schema} and {@code polygon}. No AWT, no GL, no running scene.
 */
@NullMarked
package org.selectiverenderer.document;

import org.jspecify.annotations.NullMarked;
