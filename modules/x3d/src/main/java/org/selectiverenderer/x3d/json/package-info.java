/**
 * Parses scenes in the JSON encoding of X3D, as defined by the Web3D Consortium's X3D JSON schema.
 *
 * <p>{@code "@name"} is an attribute, {@code "-field"} holds the nodes of a field, {@code
 * "#comment"} a comment and {@code "#sourceCode"} a script's text; any other object or array of
 * objects is an element of that name. A text is thus converted to elements of the XML encoding,
 * which the reader interprets in the same way for all encodings. The order of an object's members
 * matters only for elements.
 *
 * <p>In: text. Out: calls of a {@link org.selectiverenderer.x3d.source.ElementTreeBuilder}. Uses
 * {@code x3d.source}, {@code x3d.catalogue}, {@code x3d.field}, {@code formats.json} and the JSON
 * parser Jackson.
 */
@NullMarked
package org.selectiverenderer.x3d.json;

import org.jspecify.annotations.NullMarked;
