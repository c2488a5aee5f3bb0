package org.selectiverenderer.study.questionnaire;

import java.util.Locale;

/** Names of the sound files that a study may play. */
public final class AudioFileName {
  /** What is wrong with another name, as a sentence. */
  public static final String NEEDED = "an audio must be a WAV, AIFF, AU or MP3 file";

  private AudioFileName() {}

  /** Returns whether the ending of a name is that of a sound file that can be read. */
  public static boolean known(String name) {
    return name.toLowerCase(Locale.ROOT).matches(".*\\.(wav|aiff?|aifc|au|snd|mp[23])");
  }
}
