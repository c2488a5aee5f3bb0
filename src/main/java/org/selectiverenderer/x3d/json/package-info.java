/**
 * Scenes in X3D's JSON encoding, as the Web3D Consortium's X3D JSON schema has it.
 *
 * <p>{@code "@name"} is an attribute, {@code "-field"} holds the nodes of a field, {@code
 * "#comment"} a comment and {@code "#sourceCode"} a script's text; any other object or list of
 * objects is an element of that name. So a text says elements of the XML encoding, and what they
 * mean is said by who reads elements, for all encodings alike. The order of an object's members
 * says nothing, but for the order of elements.
 *
 * <p>In: text. Out: calls of a {@link org.selectiverenderer.x3d.source.DocumentBuilder}. Uses
 * {@code x3d.source}, {@code x3d.catalogue}, {@code x3d.field}, {@code base.json} and the JSON
 * parser Jackson.
 */
@NullMarked
package org.selectiverenderer.x3d.json;

import org.jspecify.annotations.NullMarked;
