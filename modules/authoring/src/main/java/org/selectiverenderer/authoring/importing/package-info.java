/**
 * Models that become part of a scene: linked by an Inline, or converted to an X3D file beside the
 * scene with their pictures.
 *
 * <p>In: the file of a model or scene that {@code x3d.model} and {@code x3d.read} read, and the
 * scene that it is to be part of. Out: files to write, and an edit of the scene. No existing file
 * is ever replaced. Uses {@code authoring}, {@code authoring.file}, {@code authoring.packaging},
 * {@code models}, {@code geometry} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.authoring.importing;

import org.jspecify.annotations.NullMarked;
