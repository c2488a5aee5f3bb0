/**
 * The node types of X3D 4.0 as data: one table of nodes and one of fields, among the resources of
 * this package.
 *
 * <p>What the standard says of a node type (fields, types, access, defaults, containment) stands
 * there once. A node of a file and one of a running scene hold values by field index and are both a
 * {@link org.selectiverenderer.x3d.catalogue.NodeView}; tessellation and metadata are written
 * against that. A node type with a behaviour of its own has one class in {@code runtime.nodes}; all
 * others are plain nodes that keep and pass on events.
 *
 * <p>In: the name of a node type. Out: its fields. Uses {@code x3d.field} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.catalogue;

import org.jspecify.annotations.NullMarked;
