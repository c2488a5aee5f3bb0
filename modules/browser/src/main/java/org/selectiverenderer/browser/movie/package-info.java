/**
 * Movies of MovieTextures (X3D 4.0, 18.4.2). {@link
 * org.selectiverenderer.browser.movie.MovieReader} makes a {@link
 * org.selectiverenderer.browser.movie.Movie} of a file, which knows its duration and its first
 * frame. A {@link org.selectiverenderer.browser.movie.MoviePlayback} is the playback of a movie by
 * a texture: the scene sets its time, the renderer gets the frame of that time. Frames are decoded
 * only on request, a few ahead, by the threads of a {@link
 * org.selectiverenderer.browser.movie.MovieDecoderPool}: a run that draws nothing decodes only the
 * first frame.
 *
 * <p>In: files, times. Out: frames. Uses {@code browser.movie.mpeg} and {@code x3d.url}; ImageIO
 * reads GIF, which needs no display.
 */
@NullMarked
package org.selectiverenderer.browser.movie;

import org.jspecify.annotations.NullMarked;
