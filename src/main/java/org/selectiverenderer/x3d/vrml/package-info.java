/**
 * Scenes written in curly brackets: ClassicVRML (ISO/IEC 19776-2) and VRML97 (ISO/IEC 14772-1).
 *
 * <p>{@code VrmlParser} reads the statements of a file and {@code NodeParser} the nodes, both by
 * one {@code VrmlScanner}, and say what they find as elements of the XML encoding: a field of
 * values becomes an attribute, a node in a field a child element, with {@code containerField} where
 * it would not get there by itself; IS becomes {@code IS} with {@code connect}; what VRML97 calls
 * otherwise gets X3D's name ({@link org.selectiverenderer.x3d.catalogue.FormerNames}). What the
 * elements mean is said by who reads elements, for all encodings alike. Values stay where they are
 * in the text and are read by {@code x3d.field}, whose syntax of numbers and strings is that of
 * VRML.
 *
 * <p>A text that breaks the grammar ends there, and what was before it is kept; a field that its
 * node does not have is passed over, if what follows it is a value.
 *
 * <p>In: text. Out: calls of a {@link org.selectiverenderer.x3d.source.DocumentBuilder}. Uses
 * {@code x3d.source}, {@code x3d.catalogue} and {@code x3d.field}.
 */
@NullMarked
package org.selectiverenderer.x3d.vrml;

import org.jspecify.annotations.NullMarked;
