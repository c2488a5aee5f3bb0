/**
 * The rehearsal of a study: what a session would meet, checked and shown before anybody comes.
 *
 * <p>In: a {@link org.selectiverenderer.study.session.LoadedStudy}. Out: findings with their places
 * in files, polygons and pictures of what participants see from each viewpoint in each condition,
 * and a page of all screens. Scenes are loaded as sessions load them, by {@code walkthrough};
 * pictures are drawn offscreen by {@code render}, where there is OpenGL. Uses {@code study}, {@code
 * x3d}, {@code formats} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.app.rehearsal;

import org.jspecify.annotations.NullMarked;
