/**
 * Scenes from files: nodes, routes, prototypes and what else an X3D file says.
 *
 * <p>The reader makes nodes of the parser's events as they come, and elements only for the bodies
 * of prototypes: a tree of a 30 MB scene would cost memory and time for nothing.
 *
 * <p>In: bytes of a file. Out: an {@link org.selectiverenderer.x3d.read.X3dFile} and problems with
 * their places. Prototypes of other files come from {@code Libraries}: {@code FileLibraries} reads
 * each library of a scene once, without what it names in turn, and {@code ExternReader} asks for
 * one when a file has an instance. Uses {@code x3d.files}, {@code x3d.source}, {@code
 * x3d.catalogue}, {@code x3d.field} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.NullMarked;
