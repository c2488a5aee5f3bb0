/**
 * The source text of scenes: character encoding, XML parsing to elements with locations, and syntax
 * errors.
 *
 * <p>All XML is parsed by {@link org.selectiverenderer.x3d.source.XmlPullParser}, after a check of
 * the file by {@link org.selectiverenderer.x3d.source.Preflight}. The class {@link
 * org.selectiverenderer.x3d.source.DocumentElement} serves the validator, prototype bodies, and
 * edited texts, whose {@link org.selectiverenderer.x3d.source.ElementTree} follows the edits. The
 * elements of the validator store parsed attributes, while those of an edited text leave them in
 * the text.
 *
 * <p>The internal entities of a DOCTYPE are expanded before parsing by {@code EntityExpander},
 * within limits; an edited text keeps them, and {@code EntityMasker} hides them from the parser.
 * Nothing is fetched.
 *
 * <p>A text of another encoding is converted to the same elements: its parser calls a {@link
 * org.selectiverenderer.x3d.source.ElementTreeBuilder}, with locations in that text.
 *
 * <p>In: bytes of a file, plain or compressed. Out: text, elements, {@link
 * org.selectiverenderer.x3d.source.XmlDocument}s. Uses {@code x3d.catalogue}, {@code x3d.field},
 * {@code base.problem} and the XML parser Aalto.
 */
@NullMarked
package org.selectiverenderer.x3d.source;

import org.jspecify.annotations.NullMarked;
