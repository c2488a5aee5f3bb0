/**
 * Readers and writers of models: meshes with their materials.
 *
 * <p>In: X3D of any geometry that has faces, and OBJ, PLY, STL and glTF. Out: {@link
 * org.selectiverenderer.models.Model}, and X3D that any browser reads. Uses {@code geometry},
 * {@code x3d}, {@code base}, and the packages inside: {@code structure} checks a file of another
 * program before {@code importer} reads it in a child process, and {@code simplify} reduces meshes.
 */
@NullMarked
package org.selectiverenderer.models;

import org.jspecify.annotations.NullMarked;
