/**
 * The context menu of the selected node, the same in tree, source and 3D view. {@code NodeMenu}
 * holds groups of commands, to which each part of the window adds its own; {@code NodeEditCommands}
 * has those that apply to every node. {@code StructureCommands} changes which nodes a scene has and
 * where: it cuts, copies, pastes, deletes, duplicates, moves and inserts them.
 *
 * <p>In: a session, commands. Out: edits of the document, the clipboard. Uses {@code
 * enricher.session}, {@code enricher.text}, {@code authoring}, {@code authoring.editing}, {@code
 * authoring.nodes}, {@code authoring.structure} and {@code x3d.source}. For the event dispatch
 * thread.
 */
@NullMarked
package org.selectiverenderer.enricher.menu;

import org.jspecify.annotations.NullMarked;
