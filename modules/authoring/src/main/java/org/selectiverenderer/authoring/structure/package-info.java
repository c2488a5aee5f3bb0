/**
 * Edits of a scene's structure: where nodes may go by the standard's containment, and cutting,
 * pasting, moving, duplicating and inserting them.
 *
 * <p>{@code Containment} finds the field of a node that takes another one, from the node catalogue;
 * {@code SceneFragment} reads nodes from text, for example from the clipboard; {@link
 * org.selectiverenderer.authoring.structure.StructureEdits} makes the edits; {@link
 * org.selectiverenderer.authoring.structure.NodePalette} lists what can be inserted, with templates
 * that draw something. DEF names that are taken get the next free number, and references within
 * what is pasted follow.
 *
 * <p>In: a document, its elements, text. Out: edits, not yet performed, each one undo step. Uses
 * {@code authoring}, {@code authoring.enrichment}, {@code authoring.nodes}, {@code schema}, {@code
 * x3d}, {@code base.decimal} and {@code base.problem}. For the thread that owns the document.
 */
@NullMarked
package org.selectiverenderer.authoring.structure;

import org.jspecify.annotations.NullMarked;
