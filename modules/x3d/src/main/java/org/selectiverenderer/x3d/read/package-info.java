/**
 * Reads scenes from files: nodes, routes, prototypes and the head of a file.
 *
 * <p>The reader creates nodes directly from the parser's events, and an element tree only for
 * prototype bodies, since a tree of a 30 MB scene would waste memory and time.
 *
 * <p>In: bytes of a file. Out: an {@link org.selectiverenderer.x3d.read.X3dFile} and problems with
 * their locations. {@link org.selectiverenderer.x3d.read.PrototypeLibraryLoader} loads the
 * prototypes of other files, each library once per scene and without those that it refers to
 * itself; {@link org.selectiverenderer.x3d.read.ExternProtoResolver} requests one when a file has
 * an instance. Uses {@code x3d.url}, {@code x3d.source}, {@code x3d.catalogue}, {@code x3d.field}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.NullMarked;
