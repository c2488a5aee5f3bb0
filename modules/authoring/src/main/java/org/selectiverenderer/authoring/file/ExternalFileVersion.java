package org.selectiverenderer.authoring.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.files.InputFileReader;

/**
 * The content of a document's file after another program has changed it. It is immutable and may be
 * read by any thread.
 */
public final class ExternalFileVersion {
  private final byte[] bytes;
  private final FileFingerprint stamp;
  private final String text;
  private final boolean sound;

  private ExternalFileVersion(byte[] bytes, FileFingerprint stamp, String text, boolean sound) {
    this.bytes = bytes;
    this.stamp = stamp;
    this.text = text;
    this.sound = sound;
  }

  /**
   * Reads the file.
   *
   * @throws IOException if it cannot be read or contains no text, with a one-line message that
   *     names it
   */
  public static ExternalFileVersion read(Path file) throws IOException {
    byte[] bytes = InputFileReader.bytes(file);
    FileFingerprint stamp = FileFingerprint.of(file, bytes);
    SceneDocument there = SceneDocument.of(file.toString(), bytes);
    return new ExternalFileVersion(bytes, stamp, there.snapshot().text(), there.fault().isEmpty());
  }

  public String text() {
    return text;
  }

  /** Returns whether a document with this text would be saved as exactly these bytes. */
  public boolean sameForm(DocumentSnapshot document) {
    return Arrays.equals(document.encoder().apply(text), bytes);
  }

  FileFingerprint stamp() {
    return stamp;
  }

  boolean sound() {
    return sound;
  }
}
