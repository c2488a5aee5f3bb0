/**
 * Scenes with all files that they name: collects what a scene refers to, by Inlines also
 * indirectly, rewrites urls where a file gets another place relative to the one that names it, and
 * writes all of it into a folder or a zip archive.
 *
 * <p>In: a scene, and what it may read ({@code x3d.url}). Out: files with their places, urls that
 * are left out with the reason, files. Nothing is fetched from the network, and nothing outside of
 * the target is written. Uses {@code authoring}, {@code base.files}, {@code schema}, {@code
 * x3d.catalogue}, {@code x3d.model}, {@code x3d.read}, {@code x3d.source} and {@code x3d.url}.
 */
@NullMarked
package org.selectiverenderer.authoring.packaging;

import org.jspecify.annotations.NullMarked;
