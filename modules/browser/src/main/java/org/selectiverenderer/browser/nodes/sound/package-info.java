/**
 * Nodes that play media files (X3D 4.0, clause 16 and 18.4.2): {@link
 * org.selectiverenderer.browser.nodes.sound.AudioClipNode} plays a recording, {@link
 * org.selectiverenderer.browser.nodes.sound.SoundNode} gives it a position in space, by the
 * ellipsoids of {@link org.selectiverenderer.browser.nodes.sound.SpatialAudioGain}; {@link
 * org.selectiverenderer.browser.nodes.sound.MovieTextureNode} sets the time of a movie.
 *
 * <p>In: recordings, movies, frames. Out: their events, a voice for each Sound that is audible in a
 * frame, and the time of each movie. Audio output and drawing are elsewhere. Nodes at rest are not
 * updated per frame. Uses {@code nodes.sensor}, {@code browser.sound}, {@code browser.movie},
 * {@code browser.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.sound;

import org.jspecify.annotations.NullMarked;
