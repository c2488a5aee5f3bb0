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
 * <p><b>JLayer</b> (1.0.1.4, LGPL, 141 kB, without further libraries) decodes MPEG audio. Its last
 * release is of 2016, and the format has not changed since. It is given whole frames only, so that
 * a damaged one costs no other; what it answers differs from FFmpeg's by some 5 units of 16 bits.
 * JavaMP3 (MIT) was tried first: it fails on layer II in stereo below 192 kbit/s, on MPEG-2 and on
 * frames that are cut off. Ogg Vorbis is not read: JOrbis, from which its readers in Java come,
 * reserves memory by numbers in a file before it checks them (a file of 5 kB took all of 512 MB),
 * and has had no release since 2016.
 *
 * <p>Uses {@code x3d.url}.
 */
@NullMarked
package org.selectiverenderer.browser.sound;

import org.jspecify.annotations.NullMarked;
