package org.selectiverenderer.models.scene;

import java.nio.charset.StandardCharsets;

/** Recognises pictures by their first bytes; what a model says of them may be wrong. */
public final class PictureType {
  private PictureType() {}

  /** Returns the media type of a picture; "" if it is of none that is known. */
  public static String of(byte[] picture) {
    String head = new String(picture, 0, Math.min(picture.length, 12), StandardCharsets.ISO_8859_1);
    if (head.startsWith("\u0089PNG")) {
      return "image/png";
    }
    if (head.startsWith("\u00ff\u00d8")) {
      return "image/jpeg";
    }
    if (head.startsWith("RIFF") && head.endsWith("WEBP")) {
      return "image/webp";
    }
    if (head.startsWith("GIF8")) {
      return "image/gif";
    }
    if (head.startsWith("BM")) {
      return "image/bmp";
    }
    return head.startsWith("DDS ") ? "image/vnd-ms.dds" : "";
  }
}
