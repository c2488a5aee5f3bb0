/**
 * The vocabulary of the thesis: which schemas an area activates, and which version of an object
 * belongs to which schema. The only place that knows the names of the metadata (thesis 4.2.2).
 *
 * <p>{@link org.selectiverenderer.schema.Activation} is the real-time algorithm of Figs 48 and 49
 * on plain keys: the controller runs it on a browser's nodes, the polygon statistics on a file's.
 *
 * <p>In: metadata nodes, seen through {@link org.selectiverenderer.schema.MetadataSource}. Out:
 * {@link org.selectiverenderer.schema.SensorSchemas}, {@link
 * org.selectiverenderer.schema.SwitchSchemas}, changes of choices, and problems. Uses {@code
 * base.problem} for names that are nearly alike; knows no files, nothing of a running scene, the
 * SAI, AWT or GL.
 */
@NullMarked
package org.selectiverenderer.schema;

import org.jspecify.annotations.NullMarked;
