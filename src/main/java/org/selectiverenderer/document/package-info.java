/**
 * A scene's file as its author's text, open for editing: lossless, every edit a named step that can
 * be undone, the elements and their places known after each.
 *
 * <p>The text is the truth, never a running scene: what an edit leaves alone keeps every byte.
 * {@link org.selectiverenderer.x3d.source.EncodedText} turns the characters into the file's bytes
 * again, with encoding and byte order mark, and knows when it cannot: such a document can be looked
 * at but not changed. Attributes are read from the text when asked for. A text that is not well
 * formed has no tree and a fault with its place; nothing is guessed.
 *
 * <p>An edit is a few replacements of characters and a name; undoing it is its inverse. The tree of
 * elements follows: for each replacement the smallest element around it is found, and of that only
 * what lies between its last child before and its first child behind is parsed again; the offsets
 * of all later elements are shifted. So elements that were not touched stay the same objects (a
 * selection survives), and an edit costs one pass over the elements behind it: a scene of 30 MB
 * opens in less than a second on 4 cores, and an edit of it takes some 10 milliseconds. Where a
 * part does not parse, all of the text is read again and tells where the fault is. {@code
 * RandomEditsTest} holds the tree against a fresh one after thousands of random edits.
 *
 * <p>The library domtrip-core was the alternative: it keeps files byte for byte too, but knows no
 * positions in the text, which source view and messages need, has no undo, and writes all of the
 * file to show one change.
 *
 * <p>A step may write files beside the document's own, such as versions of an object ({@link
 * org.selectiverenderer.document.StepFile}): they belong to the step, undone and redone with it.
 *
 * <p>A document belongs to one thread at a time. Snapshots of it are values.
 *
 * <p>Within: {@code nodes} (edits that fit every node: names, copies, taking out), {@code hand}
 * (what is done to the text itself: search, comments, pasting, completion, fields), {@code
 * enrichment} (the vocabulary of the thesis in a document), {@code area} (where its areas are, in
 * the scene's frame), {@code switches} (Switches made of nodes, and their choices), {@code ratings}
 * (expectancy ratings to metadata), {@code versions} (the polygon count process as an edit), {@code
 * file} (saving, recovery, differences), {@code headless} (the edits of the enricher, told by
 * tables).
 *
 * <p>In: bytes of a file, edits. Out: text, elements, bytes. Uses {@code x3d}, {@code base.problem}
 * and {@code base.files}; the packages within also {@code schema}, {@code geometry}, {@code
 * polygon} and the rest of {@code base}. No AWT, no GL, no running scene.
 */
@NullMarked
package org.selectiverenderer.document;

import org.jspecify.annotations.NullMarked;
