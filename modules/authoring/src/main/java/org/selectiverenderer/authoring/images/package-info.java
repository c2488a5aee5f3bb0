/**
 * The images that a scene names: which nodes name them, where missing ones are found, and the edit
 * that has the scene name those.
 *
 * <p>In: a document, a folder to look in. Out: references, files, edits. Uses {@code authoring},
 * {@code x3d} and {@code base}; decodes no image.
 */
@NullMarked
package org.selectiverenderer.authoring.images;

import org.jspecify.annotations.NullMarked;
