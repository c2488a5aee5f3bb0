/**
 * Films: pictures that follow each other in time (X3D 4.0, 18.4.2). {@link
 * org.selectiverenderer.runtime.movie.MovieReader} makes a {@link
 * org.selectiverenderer.runtime.movie.Movie} of a file, which knows how long it is and what it
 * begins with. A {@link org.selectiverenderer.runtime.movie.Film} is a movie that a texture shows:
 * the scene says where it stands, whoever draws asks for the picture of that moment. Only then are
 * pictures decoded, a few ahead, by the threads of a {@link
 * org.selectiverenderer.runtime.movie.ProjectionRoom}: a run that draws nothing decodes none but
 * the first.
 *
 * <p>In: files, times. Out: pictures. Uses {@code runtime.movie.mpeg} and {@code x3d.files};
 * ImageIO reads GIF, which needs no display.
 */
@NullMarked
package org.selectiverenderer.runtime.movie;

import org.jspecify.annotations.NullMarked;
