package org.selectiverenderer.document.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** How to tell that a file is still the one that was read or written. */
record Stamp(long size, FileTime time, String digest) {
  static Stamp of(Path file, byte[] content) throws IOException {
    BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
    return new Stamp(found.size(), found.lastModifiedTime(), digest(content));
  }

  /** Compares; the content decides where the time alone has changed. */
  DiskState compare(Path file) throws IOException {
    try {
      BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
      if (found.size() == size && found.lastModifiedTime().equals(time)) {
        return DiskState.SAME;
      }
      boolean same = found.size() == size && digest(Files.readAllBytes(file)).equals(digest);
      return same ? DiskState.SAME : DiskState.CHANGED;
    } catch (NoSuchFileException e) {
      return DiskState.GONE;
    }
  }

  static String digest(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
