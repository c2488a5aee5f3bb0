/**
 * What the urls of a scene mean, and which of them may be read.
 *
 * <p>{@link org.selectiverenderer.x3d.files.ContentRoot} alone decides, by the folder of the scene
 * that the user opened (its own files, those of its project) and by what the user allows besides
 * ({@link org.selectiverenderer.x3d.files.ContentAccess}: folders, hosts of the network). Files
 * inlined name others relative to themselves ({@link org.selectiverenderer.x3d.files.ContentBase}),
 * within the same bounds; so do Anchors, scripts, prototypes, and what an application sets through
 * the SAI. Links are followed and must not lead outside.
 *
 * <p>In: a scene's folder, urls. Out: {@link org.selectiverenderer.x3d.files.Content} with a name,
 * bytes and a place where its own urls start, or why there is none. Nothing is fetched unless the
 * user allows the host; then by {@link org.selectiverenderer.x3d.files.Network}, the only place
 * that does. The files that scenes have named ({@link org.selectiverenderer.x3d.files.FilesNamed})
 * are known to whoever writes others. Uses {@code x3d.catalogue}, {@code base.json} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.files;

import org.jspecify.annotations.NullMarked;
