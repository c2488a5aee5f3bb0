/**
 * Audio playback: reads sound files, mixes voices, and writes to the machine's sound device. The
 * only package that uses {@code javax.sound}.
 *
 * <p>In: files as {@code x3d.url} gives them; {@link org.selectiverenderer.browser.sound.Voice}s,
 * one for each sound that is audible in a frame. Out: {@link
 * org.selectiverenderer.browser.sound.AudioBuffer}s, and what the {@link
 * org.selectiverenderer.browser.sound.AudioPlayer} plays on its own thread {@code sound}. The
 * behaviour of sound nodes is in {@code browser.nodes.sound}; {@code app} connects scene and
 * device. A scene without sound loads nothing of this package and starts no thread.
 *
 * <p>Uses {@code x3d.url}.
 */
@NullMarked
package org.selectiverenderer.browser.sound;

import org.jspecify.annotations.NullMarked;
