/**
 * Sounds as samples: read from files, mixed, sent to the machine's sound device. The only package
 * that uses {@code javax.sound}.
 *
 * <p>In: files as {@code x3d.files} gives them; {@link org.selectiverenderer.runtime.sound.Voice}s,
 * one for each sound that is heard in a frame. Out: {@link
 * org.selectiverenderer.runtime.sound.Recording}s, and what the {@link
 * org.selectiverenderer.runtime.sound.Speaker} plays on its own thread {@code sound}. What a node
 * does with a recording is in {@code runtime.nodes.sound}; who listens, {@code app} says. A scene
 * without a sound loads nothing of this and starts no thread.
 *
 * <p>Uses {@code x3d.files}.
 */
@NullMarked
package org.selectiverenderer.runtime.sound;

import org.jspecify.annotations.NullMarked;
