/**
 * Audio playback: reads sound files, mixes voices, and writes to the machine's sound device. The
 * only package that uses {@code javax.sound}.
 *
 * <p>In: files as {@code x3d.files} gives them; {@link org.selectiverenderer.runtime.sound.Voice}s,
 * one for each sound that is audible in a frame. Out: {@link
 * org.selectiverenderer.runtime.sound.AudioBuffer}s, and what the {@link
 * org.selectiverenderer.runtime.sound.AudioPlayer} plays on its own thread {@code sound}. The
 * behaviour of sound nodes is in {@code runtime.nodes.sound}; {@code app} connects scene and
 * device. A scene without sound loads nothing of this package and starts no thread.
 *
 * <p>Uses {@code x3d.files}.
 */
@NullMarked
package org.selectiverenderer.runtime.sound;

import org.jspecify.annotations.NullMarked;
