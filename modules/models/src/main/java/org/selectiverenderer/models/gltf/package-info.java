/**
 * glTF 2.0 translated into X3D 4.0.
 *
 * <p>In: the bytes of a glTF file, and the files that it may refer to. Out: the text of a scene,
 * and problems with the path in the model. The JSON is read with Jackson and the numbers by {@code
 * GltfAccessors}, after {@code structure} has found that they lie in the file: libraries for glTF
 * trust what a file announces. Uses {@code structure}, {@code draco}, {@code x3d.model}, {@code
 * x3d.url}, {@code x3d.write}, {@code base}, and meshoptimizer for compressed buffers.
 */
@NullMarked
package org.selectiverenderer.models.gltf;

import org.jspecify.annotations.NullMarked;
