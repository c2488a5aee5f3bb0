/**
 * The memory schemas of the thesis: the schemas that an area activates, and the schemas that each
 * version of an object belongs to. Only this package knows the names of the metadata (thesis
 * 4.2.2).
 *
 * <p>{@link org.selectiverenderer.schema.SchemaActivation} is the real-time algorithm of Figs 48
 * and 49 on arbitrary keys: the controller runs it on a browser's nodes, the polygon statistics on
 * a file's.
 *
 * <p>The versions of an object differ in one {@link org.selectiverenderer.schema.Quality}: the
 * MetadataSet of a choice may name it in a MetadataString {@code quality}, else it is polygons, as
 * in the thesis. Further qualities of the object are values of fields, {@link
 * org.selectiverenderer.schema.FieldQuality}: each has a set of its own in the set {@code
 * fieldQualities}, the metadata of the metadata of the Switch, which the loops over {@code value}
 * in the thesis and in other browsers pass over. Each quality is activated as a Switch of its own,
 * so that two qualities of two levels are four looks of an object without four versions.
 *
 * <p>In: metadata nodes as {@link org.selectiverenderer.schema.MetadataNode}s. Out: {@link
 * org.selectiverenderer.schema.SensorSchemas}, {@link org.selectiverenderer.schema.SwitchSchemas},
 * {@link org.selectiverenderer.schema.FieldQuality}, changes of choices, and problems. Uses {@code
 * base.problem} for similar names; independent of files, running scenes, the SAI, AWT and GL.
 */
@NullMarked
package org.selectiverenderer.schema;

import org.jspecify.annotations.NullMarked;
