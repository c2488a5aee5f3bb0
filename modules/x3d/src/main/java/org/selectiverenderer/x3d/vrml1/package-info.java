/**
 * The parser for VRML 1.0 (Bell, Parisi and Pesce, 26 May 1995), the language before VRML97, whose
 * nodes change a state as they are traversed: a Material counts for the shapes that follow it, up
 * to the end of the Separator.
 *
 * <p>{@code Vrml1NodeParser} parses a text to a tree of nodes without knowing their types, {@code
 * Vrml1Translator} traverses the tree with the state and makes the X3D elements that show the same,
 * and {@code X3dElement} writes these to a document. {@code LightGroups} keeps the groups of lights
 * from nesting without end. Values keep their digits and places as far as X3D has the same field.
 * What X3D cannot express is told and left out. How often nodes are traversed and how much text is
 * copied is limited, since a node may be used any number of times.
 *
 * <p>In: text. Out: calls of a {@link org.selectiverenderer.x3d.source.ElementTreeBuilder}. Uses
 * {@code x3d.source}, {@code x3d.field}, the scanner of {@code x3d.vrml}, {@code base.decimal} and
 * JOML for matrices.
 */
@NullMarked
package org.selectiverenderer.x3d.vrml1;

import org.jspecify.annotations.NullMarked;
