/**
 * Resolves the urls of a scene, and controls which of them may be read.
 *
 * <p>{@link org.selectiverenderer.x3d.url.UrlResolver} alone decides, by the folder of the scene
 * that the user opened (its own files, those of its project) and by the folders and hosts that the
 * user allows in addition ({@link org.selectiverenderer.x3d.url.ContentAccessPolicy}). Inlined
 * files refer to others relative to themselves ({@link org.selectiverenderer.x3d.url.BaseUrl}),
 * with the same restrictions, as do Anchors, scripts, prototypes, and urls set through the SAI.
 * Symbolic links are followed and must not lead outside.
 *
 * <p>In: a scene's folder, urls. Out: {@link org.selectiverenderer.x3d.url.UrlContent} with a name,
 * bytes and a base for its own urls, or the reason why there is none. Nothing is fetched unless the
 * user allows the host; only {@link org.selectiverenderer.x3d.url.HttpFetcher} fetches files.
 * {@link org.selectiverenderer.x3d.url.ReferencedFiles} lists the files to which scenes refer, so
 * that no output overwrites them. Uses {@code x3d.catalogue}, {@code formats.json} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.url;

import org.jspecify.annotations.NullMarked;
