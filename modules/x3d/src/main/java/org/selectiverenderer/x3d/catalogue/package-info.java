/**
 * The node types of X3D as data: a table of nodes and a table of fields for X3D 4.0, and another
 * pair for X3D 4.1 and extensions, among the resources of this package.
 *
 * <p>The tables define the fields of each node type with their types, access, defaults and
 * containment. Nodes of a file and of a running scene store values by field index and both
 * implement {@link org.selectiverenderer.x3d.catalogue.NodeView}, which tessellation and metadata
 * use. A node type with behaviour has a class in {@code browser.nodes}; all others are plain nodes
 * that store and forward events.
 *
 * <p>In: the name of a node type. Out: its fields. Uses {@code x3d.field} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.catalogue;

import org.jspecify.annotations.NullMarked;
