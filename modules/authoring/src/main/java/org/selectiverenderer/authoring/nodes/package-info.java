/**
 * Edits that apply to every node of a document: rename, copy, remove. Each is one undo step and
 * leaves no dangling references.
 *
 * <p>The scope of a DEF name is its scene or the declaration of its prototype ({@link
 * org.selectiverenderer.x3d.source.ElementScope}); {@code NodeReferences} lists the references to
 * it in this scope: USE, ROUTE, EXPORT, IMPORT. {@link
 * org.selectiverenderer.authoring.nodes.NodeEdits} creates the edits; {@link
 * org.selectiverenderer.authoring.nodes.CopyNaming} names the nodes of copies, {@code
 * MetadataNaming} lets metadata follow the name of its object or area. {@code SceneExcerpt} is the
 * scene of one node, for its picture.
 *
 * <p>In: a document, an element, names. Out: edits, not yet performed. Uses {@code authoring},
 * {@code schema}, {@code x3d.source} and {@code x3d.write}.
 */
@NullMarked
package org.selectiverenderer.authoring.nodes;

import org.jspecify.annotations.NullMarked;
