/**
 * A scene's file as its author's text, opened for editing: lossless, every edit is a named step
 * that can be undone, and the elements and their positions are known after each edit.
 *
 * <p>The text is authoritative, never a running scene: parts that an edit does not change keep
 * every byte. {@link org.selectiverenderer.x3d.source.DecodedText} turns the characters into the
 * file's bytes again, with encoding and byte order mark, and knows when it cannot: such a document
 * is read-only. Attributes are read from the text on demand. A text that is not well-formed has no
 * tree, but an error with its location; nothing is guessed.
 *
 * <p>An edit is a few replacements of characters and a name; undoing it is its inverse. The element
 * tree is updated incrementally: for each replacement the smallest enclosing element is found, and
 * of that only the part between the last child before and the first child after the replacement is
 * parsed again; the offsets of all later elements are shifted. So untouched elements stay the same
 * objects (a selection survives), and an edit costs one pass over the elements after it: a scene of
 * 30 MB opens in less than a second on 4 cores, and an edit of it takes some 10 milliseconds. Where
 * a part does not parse, the text is parsed from there to the error; the tree of the text before is
 * kept, and mended when what has changed since is well-formed again. What cannot be decided in a
 * part has the whole text parsed. {@code RandomEditsTest} compares the tree with a freshly parsed
 * one after thousands of random edits.
 *
 * <p>The library domtrip-core was the alternative: it keeps files byte for byte too, but knows no
 * positions in the text, which source view and messages need, has no undo, and writes all of the
 * file to show one change.
 *
 * <p>A step may write files beside the document's own, such as versions of an object ({@link
 * org.selectiverenderer.authoring.UndoableFileWrite}): they belong to the step, undone and redone
 * with it.
 *
 * <p>A document belongs to one thread at a time. Snapshots of it are values.
 *
 * <p>Within: {@code nodes} (edits that apply to every node: rename, copy, remove), {@code hand}
 * (editing of the text itself: search, comments, pasting, completion, fields), {@code enrichment}
 * (the schema metadata of a document), {@code area} (its areas in scene coordinates), {@code
 * placement} (moving, turning, scaling, aligning and grouping), {@code structure} (cutting,
 * pasting, moving and inserting nodes by the standard's containment), {@code switches} (Switches
 * made of nodes, and their choices), {@code ratings} (expectancy ratings to metadata), {@code
 * versions} (the polygon count process as an edit), {@code file} (saving, recovery, differences),
 * {@code creation} (new scenes), {@code importing} (models that become part of a scene), {@code
 * packaging} (scenes with all files that they name), {@code headless} (the edits of the enricher,
 * given by tables).
 *
 * <p>In: bytes of a file, edits. Out: text, elements, bytes. Uses {@code x3d}, {@code base.problem}
 * and {@code base.files}; the packages within also {@code schema}, {@code geometry}, {@code
 * polygon} and the rest of {@code base}. No AWT, no GL, no running scene.
 */
@NullMarked
package org.selectiverenderer.authoring;

import org.jspecify.annotations.NullMarked;
