/**
 * Writer of X3D scenes as glTF 2.0.
 *
 * <p>In: a scene that {@code x3d.read} has read, what it inlines, and a converter of images into
 * PNG ({@link org.selectiverenderer.models.gltf.write.PngTranscoder}). Out: the bytes of a GLB or
 * glTF file, and a problem for each kind of node that glTF cannot hold. {@link
 * org.selectiverenderer.models.gltf.write.GlbWriter} begins; docs/encodings.md has a table of what
 * becomes of each node. Uses {@code x3d}, {@code geometry}, {@code formats} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.models.gltf.write;

import org.jspecify.annotations.NullMarked;
