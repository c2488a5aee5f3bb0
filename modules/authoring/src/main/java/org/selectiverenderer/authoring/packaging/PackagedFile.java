package org.selectiverenderer.authoring.packaging;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A file of a package.
 *
 * @param target its place, relative to the target folder
 * @param source the file that it is a copy of
 * @param changed its content, where it is not that of the source
 */
public record PackagedFile(Path target, Path source, Optional<byte[]> changed) {
  /** Returns the size in bytes. */
  public long size() throws IOException {
    return changed.isPresent() ? changed.get().length : Files.size(source);
  }

  /** Opens the content. */
  InputStream open() throws IOException {
    return changed.isPresent()
        ? new ByteArrayInputStream(changed.get())
        : Files.newInputStream(source);
  }
}
