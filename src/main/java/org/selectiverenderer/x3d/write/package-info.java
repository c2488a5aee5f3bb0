/**
 * Writing X3D: the same scene gives the same bytes on every machine; lines end in LF.
 *
 * <p>In: values as {@link org.selectiverenderer.x3d.field.FieldType} represents them, nodes as
 * {@link org.selectiverenderer.x3d.catalogue.NodeView}s, or elements by name. Out: the text of a
 * file. Values ({@link org.selectiverenderer.x3d.write.ValueText}) and the walk over nodes ({@link
 * org.selectiverenderer.x3d.write.NodeText}) know nothing of XML; quotes, references, container
 * fields and layout are {@link org.selectiverenderer.x3d.write.X3dWriter}'s, so that another
 * encoding is another one of these.
 *
 * <p>A document that is written anew in another encoding ({@link
 * org.selectiverenderer.x3d.write.SceneFormat}) first becomes {@code SceneItem}s, which know the
 * types of values, the fields of nodes and the places of comments; the text of each encoding is one
 * class that writes these. Uses {@code x3d.catalogue}, {@code x3d.field}, {@code x3d.source},
 * {@code x3d.read}, {@code base.problem}, {@code base.decimal} and Jackson's quoting of strings.
 */
@NullMarked
package org.selectiverenderer.x3d.write;

import org.jspecify.annotations.NullMarked;
