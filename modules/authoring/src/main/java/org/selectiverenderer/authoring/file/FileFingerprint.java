package org.selectiverenderer.authoring.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import org.selectiverenderer.base.files.Sha256;

/** Size, time and digest of a file, by which later changes are detected. */
record FileFingerprint(long size, FileTime time, String digest) {
  static FileFingerprint of(Path file, byte[] content) throws IOException {
    BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
    return new FileFingerprint(found.size(), found.lastModifiedTime(), Sha256.of(content));
  }

  /** Compares the stamp with a file; the content decides where only the time has changed. */
  FileState compare(Path file) throws IOException {
    try {
      BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
      if (found.size() == size && found.lastModifiedTime().equals(time)) {
        return FileState.SAME;
      }
      boolean same = found.size() == size && Sha256.of(Files.readAllBytes(file)).equals(digest);
      return same ? FileState.SAME : FileState.CHANGED;
    } catch (NoSuchFileException e) {
      return FileState.GONE;
    }
  }
}
