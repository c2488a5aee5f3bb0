/**
 * A file as text and as XML: bytes to characters and back, elements with their places, what is
 * wrong as XML.
 *
 * <p>All XML is parsed by {@code XmlEvents}, after a look at the file by {@code Preflight}. There
 * is one element, {@link org.selectiverenderer.x3d.source.DocumentElement}: the validator's, that
 * of bodies of prototypes, and that of a text that is edited, whose elements follow the edits in an
 * {@link org.selectiverenderer.x3d.source.ElementTree}. Where each looks for something else, it
 * keeps something else: the validator's elements have their attributes as values, those of an
 * edited text leave them in the text.
 *
 * <p>A text of another encoding becomes the same elements: its parser calls a {@link
 * org.selectiverenderer.x3d.source.DocumentBuilder}, and the elements' places are those of that
 * text.
 *
 * <p>In: bytes of a file, plain or compressed. Out: text, elements, {@link
 * org.selectiverenderer.x3d.source.XmlDocument}s. Uses {@code x3d.catalogue}, {@code x3d.field},
 * {@code base.problem} and the XML parser Aalto.
 */
@NullMarked
package org.selectiverenderer.x3d.source;

import org.jspecify.annotations.NullMarked;
