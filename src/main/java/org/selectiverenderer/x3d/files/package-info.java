/**
 * Which files a scene may name, and which of a node's urls is meant.
 *
 * <p>A scene may name files in the folder of the scene that the user opened and below it, and in a
 * folder {@code inlineNodes} beside that folder and below it ({@code scenes/} and {@code
 * inlineNodes/} are siblings, as in the thesis). Files inlined name others relative to themselves,
 * within the same two folders; so do Anchors, and what an application sets through the SAI. Links
 * are followed and must not lead outside. Nothing is ever fetched from the network. {@link
 * org.selectiverenderer.x3d.files.ContentRoot} alone decides.
 *
 * <p>In: a scene's file, urls. Out: paths, or why a file may not be read. Uses {@code
 * x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.files;

import org.jspecify.annotations.NullMarked;
