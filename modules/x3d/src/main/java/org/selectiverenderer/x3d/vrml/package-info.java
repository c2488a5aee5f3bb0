/**
 * Parses scenes in ClassicVRML (ISO/IEC 19776-2) and VRML97 (ISO/IEC 14772-1).
 *
 * <p>{@link org.selectiverenderer.x3d.vrml.VrmlParser} parses the statements of a file and {@link
 * org.selectiverenderer.x3d.vrml.NodeParser} the nodes, both with one {@link
 * org.selectiverenderer.x3d.vrml.VrmlScanner}, and convert them to elements of the XML encoding: a
 * field value becomes an attribute, and a node in a field a child element, with {@code
 * containerField} if the field is not the default; IS becomes {@code IS} with {@code connect};
 * names of VRML97 are replaced by those of X3D ({@link
 * org.selectiverenderer.x3d.catalogue.LegacyFieldNames}). The reader interprets the elements in the
 * same way for all encodings. Values are parsed by {@code x3d.field}, whose syntax of numbers and
 * strings is that of VRML.
 *
 * <p>At a syntax error parsing ends, and the part before it is kept; an unknown field is skipped if
 * a value follows it.
 *
 * <p>In: text. Out: calls of a {@link org.selectiverenderer.x3d.source.ElementTreeBuilder}. Uses
 * {@code x3d.source}, {@code x3d.catalogue} and {@code x3d.field}.
 */
@NullMarked
package org.selectiverenderer.x3d.vrml;

import org.jspecify.annotations.NullMarked;
