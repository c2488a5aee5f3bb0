/**
 * Readers and writers of models: meshes with their materials.
 *
 * <p>In: X3D of any geometry that has faces, glTF, and OBJ, PLY, STL, COLLADA and FBX. Out: {@link
 * org.selectiverenderer.models.Model}, and X3D that any browser reads. {@link
 * org.selectiverenderer.models.ModelToX3d} is the door by which the reader of scenes reads models.
 * Uses {@code geometry}, {@code x3d}, {@code base}, and the packages inside: {@code gltf}
 * translates glTF, {@code scene} writes what all formats have in common, {@code structure} checks a
 * file of another program before {@code importer} reads it in a child process, and {@code simplify}
 * reduces meshes.
 */
@NullMarked
package org.selectiverenderer.models;

import org.jspecify.annotations.NullMarked;
