package org.selectiverenderer.runtime.sound;

import java.util.Arrays;
import java.util.List;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.Line;
import javax.sound.sampled.Mixer;
import javax.sound.sampled.SourceDataLine;

/** The sound devices that a machine has. */
public final class SoundDevices {
  private static final Line.Info PLAYS = new Line.Info(SourceDataLine.class);

  private SoundDevices() {}

  /** The names of those that play sounds, the one that is used first. */
  public static List<String> names() {
    return Arrays.stream(AudioSystem.getMixerInfo())
        .filter(device -> AudioSystem.getMixer(device).isLineSupported(PLAYS))
        .map(Mixer.Info::getName)
        .toList();
  }
}
