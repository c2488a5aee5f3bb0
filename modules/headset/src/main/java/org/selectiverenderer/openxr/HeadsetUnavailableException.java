package org.selectiverenderer.openxr;

import java.io.IOException;

/**
 * Thrown if there is no headset to show a scene on. The message is a whole sentence for the user.
 */
public final class HeadsetUnavailableException extends IOException {
  private static final long serialVersionUID = 1L;

  HeadsetUnavailableException(String sentence, Throwable cause) {
    super(sentence, cause);
  }

  HeadsetUnavailableException(String sentence) {
    super(sentence);
  }
}
