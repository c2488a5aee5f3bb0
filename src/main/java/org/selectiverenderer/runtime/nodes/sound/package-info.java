/**
 * What plays files (X3D 4.0, clause 16 and 18.4.2): {@link
 * org.selectiverenderer.runtime.nodes.sound.AudioClipNode} is what sounds and when, {@link
 * org.selectiverenderer.runtime.nodes.sound.SoundNode} where it is heard, by the ellipsoids of
 * {@link org.selectiverenderer.runtime.nodes.sound.Hearing}; {@link
 * org.selectiverenderer.runtime.nodes.sound.MovieTextureNode} says where a film stands.
 *
 * <p>In: recordings, films, frames. Out: their events, a voice of each Sound that is heard in a
 * frame, and the time of each film; who plays or shows it is not known here. What is at rest looks
 * at no frames. Uses {@code nodes.sensor}, {@code runtime.sound}, {@code runtime.movie}, {@code
 * runtime.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.sound;

import org.jspecify.annotations.NullMarked;
