package org.selectiverenderer.document.versions;

import java.io.IOException;

/** A scene has been read but is such that its text cannot be changed; the message names it. */
public final class BadSceneException extends IOException {
  private static final long serialVersionUID = 1L;

  BadSceneException(String message) {
    super(message);
  }
}
