/**
 * Further qualities of an object as values of fields: smaller pictures of its textures, other
 * shading of its shapes. What {@code versions} is to polygons, this is to the rest, without another
 * version of the object for each product.
 *
 * <p>In: a document, an object's DEF name, percents or levels of shading. Out: picture files and
 * changes of the document. Uses {@code authoring}, {@code authoring.enrichment}, {@code
 * authoring.switches}, {@code authoring.versions} for planned files, {@code schema} and {@code
 * x3d}. Pictures are scaled by whoever asks, since that takes AWT's images.
 */
@NullMarked
package org.selectiverenderer.authoring.qualities;

import org.jspecify.annotations.NullMarked;
