/**
 * The memory schemas of the thesis: the schemas that an area activates, and the schemas that each
 * version of an object belongs to. Only this package knows the names of the metadata (thesis
 * 4.2.2).
 *
 * <p>{@link org.selectiverenderer.schema.SchemaActivation} is the real-time algorithm of Figs 48
 * and 49 on arbitrary keys: the controller runs it on a browser's nodes, the polygon statistics on
 * a file's.
 *
 * <p>In: metadata nodes as {@link org.selectiverenderer.schema.MetadataNode}s. Out: {@link
 * org.selectiverenderer.schema.SensorSchemas}, {@link org.selectiverenderer.schema.SwitchSchemas},
 * changes of choices, and problems. Uses {@code base.problem} for similar names; independent of
 * files, running scenes, the SAI, AWT and GL.
 */
@NullMarked
package org.selectiverenderer.schema;

import org.jspecify.annotations.NullMarked;
