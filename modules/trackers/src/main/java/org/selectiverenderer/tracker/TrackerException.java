package org.selectiverenderer.tracker;

import java.io.IOException;

/**
 * Thrown if a tracker cannot be opened or was lost. The message is a whole sentence for the user.
 */
public final class TrackerException extends IOException {
  private static final long serialVersionUID = 1L;

  public TrackerException(String sentence) {
    super(sentence);
  }

  public TrackerException(String sentence, Throwable cause) {
    super(sentence, cause);
  }
}
