package org.selectiverenderer.runtime.sound;

/** No sound can be played on this machine; the message says why, in a clause. */
public final class SoundUnavailableException extends Exception {
  private static final long serialVersionUID = 1L;

  SoundUnavailableException(String message, Throwable cause) {
    super(message, cause);
  }
}
