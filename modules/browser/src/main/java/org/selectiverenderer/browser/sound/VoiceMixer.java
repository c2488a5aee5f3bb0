package org.selectiverenderer.browser.sound;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Mixes the voices of the last frame to stereo. Each voice plays on by itself from where it
 * started; the position given by a frame only counts if it differs much from that, so that
 * irregular frame times are not audible. Gains change gradually within a block. Belongs to one
 * thread.
 */
final class VoiceMixer {
  /** Largest number of simultaneous voices. */
  static final int MAX_VOICES = 32;

  /**
   * Difference in seconds between the positions of a voice and of the scene above which the voice
   * is moved to the latter.
   */
  private static final double APART = 0.25;

  /** Seconds without a frame after which the mixer falls silent. */
  private static final double SILENT = 0.5;

  private final double rate;
  private final Map<Object, Playing> playing = new IdentityHashMap<>();
  private long sinceHeard;

  /**
   * @param rate the sample rate of the output
   */
  VoiceMixer(double rate) {
    this.rate = rate;
  }

  /** Sets the voices to be played from now on. */
  void voices(List<Voice> voices) {
    sinceHeard = 0;
    List<Voice> first = voices;
    if (voices.size() > MAX_VOICES) {
      first = new ArrayList<>(voices);
      first.sort(Comparator.comparing(Voice::rank));
      first = first.subList(0, MAX_VOICES);
    }
    Set<Object> wanted = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Voice voice : first) {
      wanted.add(voice.source());
      Playing known = playing.get(voice.source());
      if (known != null && known.voice.recording() == voice.recording()) {
        known.follow(voice);
      } else {
        playing.put(voice.source(), new Playing(voice));
      }
    }
    playing.forEach((source, voice) -> voice.leaving = !wanted.contains(source));
  }

  /** Returns whether nothing is being played. */
  boolean idle() {
    return playing.isEmpty();
  }

  /**
   * Mixes a block.
   *
   * @param out receives the samples, interleaved left and right; -1 to 1, or beyond if the sum is
   *     too loud
   */
  void mix(double[] out) {
    Arrays.fill(out, 0);
    sinceHeard += out.length / 2;
    if (sinceHeard > SILENT * rate) {
      playing.values().forEach(voice -> voice.leaving = true);
    }
    playing.values().removeIf(voice -> !voice.add(out));
  }

  /** A voice with its playback position. */
  private final class Playing {
    private Voice voice;
    private double at;
    private double left;
    private double right;
    private boolean leaving;

    Playing(Voice voice) {
      this.voice = voice;
      at = voice.position() * voice.recording().rate();
      left = voice.left();
      right = voice.right();
    }

    void follow(Voice now) {
      voice = now;
      AudioBuffer recording = now.recording();
      double target = now.position() * recording.rate();
      double off = Math.abs(target - at);
      if (now.loop()) {
        off = Math.min(off, recording.frames() - off);
      }
      if (off > APART * recording.rate() * Math.max(1, now.pitch())) {
        at = target;
      }
    }

    /** Adds a block of the voice; returns whether it continues. */
    boolean add(double[] out) {
      AudioBuffer recording = voice.recording();
      double step = recording.rate() * voice.pitch() / rate;
      int frames = out.length / 2;
      double leftStep = ((leaving ? 0 : voice.left()) - left) / frames;
      double rightStep = ((leaving ? 0 : voice.right()) - right) / frames;
      boolean stereo = recording.channels() == 2;
      for (int i = 0; i < frames; i++) {
        if (at >= recording.frames()) {
          if (!voice.loop()) {
            // Stays until the scene ends it, or it would restart.
            return !leaving;
          }
          at %= recording.frames();
        }
        double first = recording.sample(0, at) / -Short.MIN_VALUE;
        double second = stereo ? recording.sample(1, at) / -Short.MIN_VALUE : first;
        double middle = (first + second) / 2;
        out[2 * i] += left * (voice.apart() ? first : middle);
        out[2 * i + 1] += right * (voice.apart() ? second : middle);
        left += leftStep;
        right += rightStep;
        at += step;
      }
      return !leaving;
    }
  }
}
