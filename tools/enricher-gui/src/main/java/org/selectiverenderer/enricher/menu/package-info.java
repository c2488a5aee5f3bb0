/**
 * What can be done with the selected node from a context menu, the same in tree, source and 3D
 * view. {@code NodeMenu} holds the commands in a row, to which each part of the window adds its own
 * by one line; {@code NodeEditing} has those that every node knows.
 *
 * <p>In: a session, commands. Out: edits of the document, the clipboard. Uses {@code
 * enricher.session}, {@code enricher.text}, {@code document}, {@code document.hand} and {@code
 * x3d.source}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.menu;

import org.jspecify.annotations.NullMarked;
