package org.selectiverenderer.document.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.Snapshot;

/** What somebody else has made of a document's file. A value, read by any thread. */
public final class DiskCopy {
  private final byte[] bytes;
  private final FileStamp stamp;
  private final String text;
  private final boolean sound;

  private DiskCopy(byte[] bytes, FileStamp stamp, String text, boolean sound) {
    this.bytes = bytes;
    this.stamp = stamp;
    this.text = text;
    this.sound = sound;
  }

  /**
   * Reads it.
   *
   * @throws IOException if it cannot be read or has no text in it, with one line that names it
   */
  public static DiskCopy read(Path file) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    FileStamp stamp = FileStamp.of(file, bytes);
    SceneDocument there = SceneDocument.of(file.toString(), bytes);
    return new DiskCopy(bytes, stamp, there.snapshot().text(), there.fault().isEmpty());
  }

  public String text() {
    return text;
  }

  /** Whether a document that took over the text would be saved as these very bytes. */
  public boolean sameForm(Snapshot document) {
    return Arrays.equals(document.encoder().apply(text), bytes);
  }

  FileStamp stamp() {
    return stamp;
  }

  boolean sound() {
    return sound;
  }
}
