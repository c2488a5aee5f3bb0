package org.selectiverenderer.browser.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class VoiceMixerTest {
  private static final short HALF = 16384;
  private static final Voice.Rank RANK = new Voice.Rank(0, 0, 1);

  private final VoiceMixer mixer = new VoiceMixer(8);

  private static AudioBuffer mono(double rate, int... samples) {
    short[] shorts = new short[samples.length];
    for (int i = 0; i < samples.length; i++) {
      shorts[i] = (short) samples[i];
    }
    return new AudioBuffer(shorts, 1, rate);
  }

  private static Voice voice(
      Object source, AudioBuffer recording, double position, boolean loop, double... gains) {
    return new Voice(source, recording, position, 1, loop, gains[0], gains[1], false, RANK);
  }

  private double[] mix(int frames) {
    double[] out = new double[2 * frames];
    mixer.mix(out);
    return out;
  }

  private static void assertMixed(double[] out, double... expected) {
    assertThat(out).containsExactly(expected, within(1e-9));
  }

  @Test
  void voicesAreAddedWithTheirGains() {
    mixer.voices(
        List.of(
            voice("a", mono(8, HALF, -HALF, HALF), 0, false, 1, 0.5),
            voice("b", mono(8, HALF, HALF, HALF), 0, false, 0, 0.5)));
    assertMixed(mix(2), 0.5, 0.5, -0.5, 0);
  }

  @Test
  void anotherRateIsInterpolated() {
    mixer.voices(List.of(voice("a", mono(4, 0, HALF, 0), 0, false, 1, 1)));
    assertMixed(mix(4), 0, 0, 0.25, 0.25, 0.5, 0.5, 0.25, 0.25);
  }

  @Test
  void theChannelsOfAStereoRecordingAreMixedOrKeptApart() {
    AudioBuffer stereo = new AudioBuffer(new short[] {HALF, 0, HALF, 0}, 2, 8);
    mixer.voices(List.of(new Voice("a", stereo, 0, 1, true, 1, 1, false, RANK)));
    assertMixed(mix(1), 0.25, 0.25);
    mixer.voices(List.of(new Voice("b", stereo, 0, 1, true, 1, 1, true, RANK)));
    mix(1); // The first one leaves.
    assertMixed(mix(1), 0.5, 0);
  }

  @Test
  void itGoesOnByItselfAndBeginsAnewInALoopOnly() {
    AudioBuffer recording = mono(8, HALF, 0, 0);
    mixer.voices(
        List.of(voice("once", recording, 0, false, 1, 0), voice("loop", recording, 0, true, 0, 1)));
    assertMixed(mix(4), 0.5, 0.5, 0, 0, 0, 0, 0, 0.5);
  }

  /** What a frame says of the position is no more exact than the frame is. */
  @Test
  void onlyAJumpOfTheSceneMovesIt() {
    AudioBuffer recording = mono(8, HALF, 0, 0, 0, 0, 0, 0, 0);
    mixer.voices(List.of(voice("a", recording, 0, true, 1, 1)));
    assertMixed(mix(2), 0.5, 0.5, 0, 0);
    mixer.voices(List.of(voice("a", recording, 0.125, true, 1, 1)));
    assertMixed(mix(2), 0, 0, 0, 0);
    mixer.voices(List.of(voice("a", recording, 0, true, 1, 1)));
    assertMixed(mix(1), 0.5, 0.5);
  }

  @Test
  void whatIsNoLongerHeardFadesOutAndIsForgotten() {
    mixer.voices(List.of(voice("a", mono(8, HALF), 0, true, 1, 1)));
    assertThat(mixer.idle()).isFalse();
    mixer.voices(List.of());
    assertMixed(mix(2), 0.5, 0.5, 0.25, 0.25);
    assertThat(mixer.idle()).isTrue();
    assertMixed(mix(1), 0, 0);
  }

  @Test
  void gainsChangeWithinABlock() {
    AudioBuffer recording = mono(8, HALF);
    mixer.voices(List.of(voice("a", recording, 0, true, 1, 0)));
    mixer.voices(List.of(voice("a", recording, 0, true, 0, 1)));
    assertMixed(mix(2), 0.5, 0, 0.25, 0.25);
    assertMixed(mix(1), 0, 0.5);
  }

  @Test
  void aSceneThatSaysNothingForHalfASecondFallsSilent() {
    mixer.voices(List.of(voice("a", mono(8, HALF), 0, true, 1, 1)));
    mix(4);
    assertThat(mixer.idle()).isFalse();
    mix(1);
    assertThat(mixer.idle()).isTrue();
  }

  /** X3D 4.0, 16.2.2. */
  @Test
  void ofTooManyTheFirstInRankAreHeard() {
    List<Voice> voices = new ArrayList<>();
    for (int i = 0; i <= VoiceMixer.MAX_VOICES; i++) {
      Voice.Rank rank = new Voice.Rank(0, 0, i == 3 ? 0.1 : 0.2);
      double gain = i == 3 ? 0 : i == 5 ? 0 : 1;
      voices.add(new Voice(i, mono(8, 1), 0, 1, true, i == 3 ? 1000 : gain, 0, false, rank));
    }
    mixer.voices(voices);
    assertThat(mix(1)[0] * 32768).isEqualTo(VoiceMixer.MAX_VOICES - 1.0, within(1e-9));
  }

  @Test
  void rankIsPriorityThenNewnessOfCuesThenIntensity() {
    Voice.Rank loud = new Voice.Rank(0.2, 9, 1);
    assertThat(new Voice.Rank(0.3, 9, 0)).isLessThan(loud);
    assertThat(new Voice.Rank(0.2, 1, 0.5)).isGreaterThan(loud);
    assertThat(new Voice.Rank(0.6, 1, 0.1)).isLessThan(new Voice.Rank(0.6, 2, 1));
  }
}
