/**
 * The vocabulary of the thesis: which schemas an area activates, and which version of an object
 * belongs to which schema. The only place that knows the names of the metadata (thesis 4.2.2).
 *
 * <p>In: metadata nodes, seen through {@link org.selectiverenderer.schema.MetadataSource}. Out:
 * {@link org.selectiverenderer.schema.SensorSchemas}, {@link
 * org.selectiverenderer.schema.SwitchSchemas} and problems. Uses package {@code x3d} for the one
 * adapter {@link org.selectiverenderer.schema.NodeMetadata}; knows nothing of a running scene, the
 * SAI, AWT or GL.
 */
@NullMarked
package org.selectiverenderer.schema;

import org.jspecify.annotations.NullMarked;
