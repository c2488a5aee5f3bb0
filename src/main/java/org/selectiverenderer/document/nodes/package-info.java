/**
 * Edits that fit every node of a document: another name, a copy, taking it out. Each is one step of
 * Undo, and leaves no name that stands for nothing.
 *
 * <p>A DEF name is known in its scene or in the body of its prototype (X3D 4.0, 4.4.4.4); {@code
 * NodeReferences} lists what speaks of it there: USE, ROUTE, EXPORT, IMPORT. {@link
 * org.selectiverenderer.document.nodes.NodeEdits} makes the edits.
 *
 * <p>In: a document, an element, names. Out: edits, not yet made. Uses {@code document}, {@code
 * x3d.source} and {@code x3d.write}.
 */
@NullMarked
package org.selectiverenderer.document.nodes;

import org.jspecify.annotations.NullMarked;
