/**
 * Writes X3D scenes, reproducibly on every machine, with LF line ends.
 *
 * <p>In: values as {@link org.selectiverenderer.x3d.field.FieldType} represents them, nodes as
 * {@link org.selectiverenderer.x3d.catalogue.NodeView}s, or elements by name. Out: the text of a
 * file. The formatting of values ({@link org.selectiverenderer.x3d.write.FieldValueFormatter}) and
 * the traversal of nodes ({@link org.selectiverenderer.x3d.write.X3dNodeWriter}) are independent of
 * XML; {@link org.selectiverenderer.x3d.write.X3dWriter} writes quotes, references, container
 * fields and layout.
 *
 * <p>To convert a document to another encoding, {@link org.selectiverenderer.x3d.write.SceneFormat}
 * first creates {@link org.selectiverenderer.x3d.write.SceneItem}s with the types of values, the
 * fields of nodes and the positions of comments, which one class per encoding writes. These items
 * have only what the encoding can hold, so that what is written can be read again: {@code
 * StatementGrammar} is the grammar of statements, {@code VrmlNames} and {@code CharacterRules}
 * change names and characters, and everything that is left out or changed is reported. Uses {@code
 * x3d.catalogue}, {@code x3d.field}, {@code x3d.source}, {@code x3d.read}, {@code base.problem},
 * {@code base.decimal} and Jackson's string escaping.
 */
@NullMarked
package org.selectiverenderer.x3d.write;

import org.jspecify.annotations.NullMarked;
