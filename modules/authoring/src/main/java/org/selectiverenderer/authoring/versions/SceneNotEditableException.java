package org.selectiverenderer.authoring.versions;

import java.io.IOException;

/** Thrown when a scene was read but its text cannot be changed; the message names the scene. */
public final class SceneNotEditableException extends IOException {
  private static final long serialVersionUID = 1L;

  SceneNotEditableException(String message) {
    super(message);
  }
}
