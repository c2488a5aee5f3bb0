package org.selectiverenderer.runtime.sound;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Mixes the voices of the last frame to stereo. Each goes on by itself from where it began: what a
 * frame says of its position counts only when it is far from there, so that uneven frames are not
 * heard. Gains change gradually, within a block. Belongs to one thread.
 */
final class VoiceMixer {
  /** Voices that are heard at once. */
  static final int MAX_VOICES = 32;

  /** Seconds between a voice and the scene above which it is set to where the scene is. */
  private static final double APART = 0.25;

  /** Seconds without a word from the scene after which nothing is heard of it. */
  private static final double SILENT = 0.5;

  private final double rate;
  private final Map<Object, Playing> playing = new IdentityHashMap<>();
  private long sinceHeard;

  /**
   * @param rate frames per second of what comes out
   */
  VoiceMixer(double rate) {
    this.rate = rate;
  }

  /** What is to be heard from now on. */
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

  /** Whether nothing is heard. */
  boolean idle() {
    return playing.isEmpty();
  }

  /**
   * Mixes a block.
   *
   * @param out left, right, left, right ...; -1 to 1, more where it is too loud
   */
  void mix(double[] out) {
    Arrays.fill(out, 0);
    sinceHeard += out.length / 2;
    if (sinceHeard > SILENT * rate) {
      playing.values().forEach(voice -> voice.leaving = true);
    }
    playing.values().removeIf(voice -> !voice.add(out));
  }

  /** A voice and how far it is. */
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
      Recording recording = now.recording();
      double target = now.position() * recording.rate();
      double off = Math.abs(target - at);
      if (now.loop()) {
        off = Math.min(off, recording.frames() - off);
      }
      if (off > APART * recording.rate() * Math.max(1, now.pitch())) {
        at = target;
      }
    }

    /** Adds a block; returns whether there is more to come. */
    boolean add(double[] out) {
      Recording recording = voice.recording();
      double step = recording.rate() * voice.pitch() / rate;
      int frames = out.length / 2;
      double leftStep = ((leaving ? 0 : voice.left()) - left) / frames;
      double rightStep = ((leaving ? 0 : voice.right()) - right) / frames;
      boolean stereo = recording.channels() == 2;
      for (int i = 0; i < frames; i++) {
        if (at >= recording.frames()) {
          if (!voice.loop()) {
            // It stays until the scene ends it, lest it began again meanwhile.
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
