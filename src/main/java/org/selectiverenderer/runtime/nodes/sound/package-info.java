/**
 * Sounds in a scene (X3D 4.0, clause 16): {@link
 * org.selectiverenderer.runtime.nodes.sound.AudioClipNode} is what sounds and when, {@link
 * org.selectiverenderer.runtime.nodes.sound.SoundNode} where it is heard, by the ellipsoids of
 * {@link org.selectiverenderer.runtime.nodes.sound.Hearing}.
 *
 * <p>In: recordings, frames. Out: the events of clips, and a voice of each Sound that is heard in a
 * frame; who plays it is not known here. A clip at rest looks at no frames. Uses {@code
 * nodes.sensor}, {@code runtime.sound}, {@code runtime.scene}, {@code x3d.catalogue} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.sound;

import org.jspecify.annotations.NullMarked;
